(** * The compliant model: motions with compl2

    A force that tends to +oo drives z and y to -oo. Data on the slow manifold: impact without collision
    ([IWC_forward]). Case II for any motion from t = -oo. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus Gronwall GammaFunction LaplaceIntegral Family
  CompliantKernel
  CompliantIntegral CompliantSlow CompliantMechanism CompliantCone CompliantUnique CompliantContact CompliantDependence.
Open Scope R_scope.

(** The force tends to +oo: z and y tend to -oo (unbounded compression). *)
Lemma penetrate (eps t0 : R) (y z l : R -> R) : 0 < eps ->
  (forall t, t0 <= t -> is_derive (fun s => eps * z s) t (- z t - eps ^ 2 * l t)) ->
  (forall t, t0 < t -> y t < z t) ->
  (forall M, exists T, forall t, T <= t -> M <= l t) ->
  forall M, exists T, forall t, T <= t -> y t <= M.
Proof.
intros He D Hyz Hl M.
set (L := (Rabs M + 1) / eps ^ 2).
destruct (Hl L) as (T0 & HT0).
set (T := Rmax T0 (t0 + 1)).
assert (HT : T0 <= T) by apply Rmax_l. assert (HT' : t0 + 1 <= T) by apply Rmax_r.
assert (He2 : 0 < eps ^ 2) by (apply pow_lt, He).
set (K := Rabs (z T + eps ^ 2 * L)).
assert (HK : 0 <= K) by apply Rabs_pos.
exists (T + eps * K). intros t Ht.
assert (HeK : 0 <= eps * K) by (apply Rmult_le_pos; lra).
assert (HTt : T <= t) by lra.
assert (Dz : forall s, T <= s -> is_derive z s (/ eps * (- z s - eps ^ 2 * l s))).
{ intros s Hs. apply (is_derive_ext (fun s => / eps * (eps * z s))).
  { intros u. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
  apply (is_derive_scal (fun s => eps * z s)), D. lra. }
assert (G : (z t + eps ^ 2 * L) * exp ((t - T) / eps) <= (z T + eps ^ 2 * L) * exp ((T - T) / eps)).
{ apply (decr_of_derive (fun s => (z s + eps ^ 2 * L) * exp ((s - T) / eps))
    (fun s => eps * (L - l s) * exp ((s - T) / eps)) T t HTt).
  - intros s Hs. eapply is_derive_val.
    + apply (is_derive_mult_R (fun s => z s + eps ^ 2 * L) (fun s => exp ((s - T) / eps)) s
        (/ eps * (- z s - eps ^ 2 * l s)) (/ eps * exp ((s - T) / eps))).
      * eapply is_derive_val. apply (is_derive_plus z (fun _ => eps ^ 2 * L)). apply Dz; lra.
        apply (is_derive_const (eps ^ 2 * L)). apply plus_zero_r.
      * auto_derive; auto. unfold Rdiv, Rminus. ring.
    + field. lra.
  - intros s Hs. assert (H1 := HT0 s ltac:(lra)). assert (H2 := exp_pos ((s - T) / eps)).
    assert (0 <= eps * (l s - L)) by (apply Rmult_le_pos; lra). nra. }
replace ((T - T) / eps) with 0 in G by (field; lra). rewrite exp_0, Rmult_1_r in G.
assert (HX : 1 + (t - T) / eps <= exp ((t - T) / eps)) by apply exp_ineq1_le.
assert (HX2 : K <= (t - T) / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * ((t - T) / eps)) with (t - T) by (field; lra). lra. }
assert (HzT : z T + eps ^ 2 * L <= K) by apply Rle_abs.
assert (EL : eps ^ 2 * L = Rabs M + 1) by (unfold L; field; lra).
assert (Hz : z t + eps ^ 2 * L <= 1).
{ apply Rnot_lt_le. intros Hlt.
  assert (1 * exp ((t - T) / eps) < (z t + eps ^ 2 * L) * exp ((t - T) / eps))
    by (apply Rmult_lt_compat_r; [apply exp_pos|auto]). lra. }
assert (Hy := Hyz t ltac:(lra)).
assert (HM : - Rabs M <= M) by (unfold Rabs; destruct Rcase_abs; lra). lra.
Qed.

Section Final.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Hypothesis Hbeta : not_nat (a3 / a1).

(** *** Forward theorem. Data on the slow manifold at t0, with y <= z: Cases I and II (0 < beta < 1) with C < 0,
    Case III with 1 < beta < 2 and C > 0; every a2, every eps > 0. Impact without collision: contact is never lost,
    the force increases strictly to +oo and y tends to -oo. *)
Theorem IWC_forward (C t0 : R) (p b y v z : R -> R) :
  (a3 / a1 < 1 /\ C < 0) \/ (1 < a3 / a1 < 2 /\ 0 < C) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = sol_p a1 t0 -> b t0 = sol_b a1 a2 a3 eps C t0 -> y t0 = sol_y a1 a2 a3 eps C t0 ->
  v t0 = sol_v a1 a3 eps C t0 -> z t0 = sol_z a1 a2 a3 eps C t0 -> y t0 <= z t0 ->
  (forall t, t0 < t -> y t < z t) /\
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros HC H Ip Ib Iy Iv Iz Hyz.
destruct (IWC_model a1 a2 a3 eps C Ha1 Ha3 Heps Hbeta HC) as (Hinc & Hinf & Hc).
assert (Hs0 : 0 <= sol_l a1 a2 a3 eps C t0).
{ rewrite <- sol_force by auto. rewrite <- Iy, <- Iz. unfold linear_force.
  apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, Heps. }
destruct (Hc t0 Hs0) as (Hpos & Hmod). clear Hc.
assert (E : forall t, t0 <= t -> y t = sol_y a1 a2 a3 eps C t /\ z t = sol_z a1 a2 a3 eps C t).
{ intros t Ht.
  destruct (forward_unique a1 a2 a3 eps Heps p b y v z (sol_p a1) (sol_b a1 a2 a3 eps C) (sol_y a1 a2 a3 eps C)
    (sol_v a1 a3 eps C) (sol_z a1 a2 a3 eps C) t0 t (fun s Hs => H s (proj1 Hs)) (fun s Hs => Hmod s (proj1 Hs))
    Ip Ib Iy Iv Iz t ltac:(lra)) as (_ & _ & E1 & _ & E2). auto. }
assert (El : forall t, t0 <= t -> contact_force eps (y t) (z t) = sol_l a1 a2 a3 eps C t).
{ intros t Ht. destruct (E t Ht) as (E1 & E2). rewrite E1, E2.
  assert (0 <= sol_l a1 a2 a3 eps C t).
  { destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|<-]; auto. apply Rlt_le, Hpos, Hl. }
  rewrite contact_force_in_contact; auto; rewrite sol_force; auto. }
assert (Hcon : forall t, t0 < t -> y t < z t).
{ intros t Ht. destruct (E t (Rlt_le _ _ Ht)) as (E1 & E2). rewrite E1, E2. apply Hpos, Ht. }
assert (Hinf' : forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)).
{ intros M. destruct (Hinf M) as (T & HT). exists (Rmax T t0). intros t Ht.
  assert (M1 := Rmax_l T t0). assert (M2 := Rmax_r T t0).
  rewrite El by lra. apply HT. lra. }
refine (conj Hcon (conj _ (conj Hinf' _))).
- intros s t Hs Hst. rewrite !El by lra. apply Hinc, Hst.
- apply (penetrate eps t0 y z (fun t => contact_force eps (y t) (z t)) Heps); auto.
  intros t Ht. apply (H t Ht).
Qed.

(** *** Case II from t = -oo. 0 < beta < 1, a2 > 0; any solution of the mechanism's equations (with compl2) on R that is
    in contact for t < t1 and whose b does not grow exponentially as t -> -oo: either contact is never lost (and the
    motion is the trivial one, or the force increases strictly to +oo), or the force decreases strictly until lift-off.
    Which of the two is decided by the force at any one time before t1. *)
Theorem case_II (t1 : R) (p b y v z : R -> R) :
  a3 / a1 < 1 -> 0 < a2 -> (forall t, p t = a1 * t) ->
  (forall t, model_at a1 a2 a3 eps contact_force p b y v z t) ->
  (forall t, t < t1 -> y t < z t) ->
  slow_at_left eps b ->
  let lam := fun t => contact_force eps (y t) (z t) in
  ((forall t, y t < z t) /\ forall t, lam t = a2 / (a3 - a1)) \/
  ((forall t, y t < z t) /\ (forall t, a2 / (a3 - a1) < lam t) /\ (forall s t, s < t -> lam s < lam t) /\
     (forall M, exists T, forall t, T <= t -> M <= lam t) /\ (forall M, exists T, forall t, T <= t -> y t <= M)) \/
  (exists t2, (forall t, t < t2 -> y t < z t) /\ y t2 = z t2 /\ (forall t, t < t2 -> lam t < a2 / (a3 - a1)) /\
     (forall s t, s < t -> t <= t2 -> lam t < lam s)).
Proof.
intros H1 H2 Hp H Hc Gb lam.
assert (HB := beta_pos a1 a3 Ha1 Ha3).
assert (Hd : 0 < a3 - a1).
{ assert (a3 / a1 * a1 = a3) by (field; lra). nra. }
destruct (contact_unique a1 a2 a3 eps Ha1 Ha3 Heps Hbeta (Finite t1) p b y v z (fun t _ => Hp t)) as (C & HC); auto.
{ intros t Ht. simpl in Ht. assert (M := H t). unfold model_at in *.
  assert (E : contact_force eps (y t) (z t) = linear_force eps (y t) (z t)).
  { apply contact_force_in_contact; auto. apply Rlt_le, linear_force_pos; auto. }
  rewrite E in M. exact M. }
simpl in HC.
(* agreement up to any te at which the slow solution still has force >= 0 *)
assert (Agree : forall te, (forall t, t <= te -> 0 <= sol_l a1 a2 a3 eps C t) -> forall t, t <= te ->
   y t = sol_y a1 a2 a3 eps C t /\ z t = sol_z a1 a2 a3 eps C t /\ lam t = sol_l a1 a2 a3 eps C t).
{ intros te Hte.
  assert (A : forall t, t <= te -> y t = sol_y a1 a2 a3 eps C t /\ z t = sol_z a1 a2 a3 eps C t).
  { intros t Ht. destruct (Rlt_le_dec t t1) as [Hl|Hl].
    - destruct (HC t Hl) as (_ & _ & E1 & _ & E2 & _). auto.
    - destruct (HC (t1 - 1) ltac:(lra)) as (F1 & F2 & F3 & F4 & F5 & _).
      destruct (forward_unique a1 a2 a3 eps Heps p b y v z (sol_p a1) (sol_b a1 a2 a3 eps C) (sol_y a1 a2 a3 eps C)
        (sol_v a1 a3 eps C) (sol_z a1 a2 a3 eps C) (t1 - 1) te) with (t := t) as (_ & _ & E1 & _ & E2); auto; try lra.
      intros s Hs. apply sol_model; auto. apply Hte; lra. }
  intros t Ht. destruct (A t Ht) as (E1 & E2). refine (conj E1 (conj E2 _)).
  unfold lam. rewrite E1, E2. rewrite contact_force_in_contact; auto; rewrite sol_force; auto. }
assert (Gn : Gamma (- (a3 / a1)) < 0) by (apply Gamma_neg; lra).
assert (HF : forall t, Derive (Fe (- a1 * eps) (a3 / a1)) t < 0).
{ intros t. apply (IWC_eps (- a1 * eps) (He' a1 eps Ha1 Heps) (a3 / a1) ltac:(lra) 1 t). lia. }
assert (Hk := k_pos a3 eps Ha3 Heps).
assert (EF : forall t, sol_l a1 a2 a3 eps C t = a2 / (a3 - a1)
  + / (- a3 * eps) * (C * Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps))).
{ intros t. unfold sol_l. field. split; lra. }
destruct (Rtotal_order C 0) as [HC0|[HC0|HC0]].
- right; left.
  assert (HCG : 0 < C * Gamma (- (a3 / a1))) by nra.
  assert (Hpos : forall t, 0 < sol_l a1 a2 a3 eps C t) by (apply force_sign; auto; lra).
  assert (E : forall t, lam t = sol_l a1 a2 a3 eps C t)
    by (intros t; apply (Agree t); [intros; apply Rlt_le, Hpos|lra]).
  assert (Hyz : forall t, y t < z t).
  { intros t. destruct (Agree t (fun s _ => Rlt_le _ _ (Hpos s)) t ltac:(lra)) as (E1 & E2 & _).
    rewrite E1, E2. apply (linear_force_pos eps); auto. rewrite sol_force; auto. }
  assert (Hinf : forall M, exists T, forall t, T <= t -> M <= lam t).
  { intros M. destruct (side_rule_up a1 a2 a3 eps C Ha1 Ha3 Heps Hbeta HCG M) as (T & HT).
    exists T. intros t Ht. rewrite E. auto. }
  refine (conj Hyz (conj _ (conj _ (conj Hinf _)))).
  + intros t. rewrite E, EF. specialize (HF (t / eps)).
    assert (0 < C * Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) by nra.
    assert (0 < / (- a3 * eps) * (C * Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps))) by (apply Rmult_lt_0_compat; auto).
    lra.
  + intros s t Hst. rewrite !E. apply sol_l_increasing; auto; lra.
  + apply (penetrate eps t1 y z lam Heps); auto. intros t _. apply (H t).
- left.
  assert (Ec : forall t, sol_l a1 a2 a3 eps C t = a2 / (a3 - a1)).
  { intros t. rewrite EF, HC0. ring. }
  assert (Hpos : forall t, 0 < sol_l a1 a2 a3 eps C t) by (intros t; rewrite Ec; apply Rdiv_lt_0_compat; auto).
  split; intros t; destruct (Agree t (fun s _ => Rlt_le _ _ (Hpos s)) t ltac:(lra)) as (E1 & E2 & E3).
  + rewrite E1, E2. apply (linear_force_pos eps); auto. rewrite sol_force; auto.
  + rewrite E3. apply Ec.
- right; right.
  destruct (lift_off_model a1 a2 a3 eps C Ha1 Ha3 Heps Hbeta (or_introl (conj H1 HC0))) as (Hdec & Hlift).
  destruct (Hlift (t1 - 1)) as (t2 & Ht2 & Z2 & P2 & N2).
  { destruct (HC (t1 - 1) ltac:(lra)) as (_ & _ & _ & _ & _ & E). rewrite <- E.
    apply linear_force_pos; auto. apply Hc; lra. }
  assert (Hge : forall t, t <= t2 -> 0 <= sol_l a1 a2 a3 eps C t).
  { intros t Ht. destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|Hl]; [apply Rlt_le, P2, Hl|rewrite Hl, Z2; apply Rle_refl]. }
  exists t2. refine (conj _ (conj _ (conj _ _))).
  + intros t Ht. destruct (Agree t2 Hge t ltac:(lra)) as (E1 & E2 & _). rewrite E1, E2.
    apply (linear_force_pos eps); auto. rewrite sol_force; auto.
  + destruct (Agree t2 Hge t2 ltac:(lra)) as (E1 & E2 & _). rewrite E1, E2.
    assert (E3 := sol_force a1 a2 a3 eps C Ha1 Ha3 Heps Hbeta t2). rewrite Z2 in E3. unfold linear_force in E3.
    assert (He2 : 0 < eps ^ 2) by (apply pow_lt, Heps).
    apply (Rmult_eq_compat_r (eps ^ 2)) in E3. unfold Rdiv in E3.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_0_l in E3 by lra. lra.
  + intros t Ht. destruct (Agree t2 Hge t ltac:(lra)) as (_ & _ & E3). rewrite E3, EF. specialize (HF (t / eps)).
    assert (0 < C * - Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < / (- a3 * eps) * (C * - Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)))
      by (apply Rmult_lt_0_compat; auto). lra.
  + intros s t Hst Ht. destruct (Agree t2 Hge t Ht) as (_ & _ & E3).
    destruct (Agree t2 Hge s ltac:(lra)) as (_ & _ & E4).
    rewrite E3, E4. apply Hdec, Hst.
Qed.

End Final.
