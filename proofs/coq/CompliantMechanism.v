(** * The compliant model: the equations of the mechanism

    In contact, with p = a1 t, modelsys1-5 are equivalent to the equation of the deviation (both ways: [recover],
    [recover_converse]). [sol_...] are the motions "trivial + C F_beta(t/eps)": the side rule; for 0 < beta < 2 the
    force is strictly monotone, so contact is kept for ever or lost exactly once. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow.
Open Scope R_scope.

Lemma contact_force_in_contact eps y z : 0 < eps -> 0 <= linear_force eps y z ->
  contact_force eps y z = linear_force eps y z.
Proof.
intros He H. unfold contact_force. destruct (Rlt_dec y z) as [Hl|Hl]; auto.
unfold linear_force in *. assert (Hp : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He).
unfold Rdiv in *. nra.
Qed.

Lemma linear_force_pos eps y z : 0 < eps -> (0 < linear_force eps y z <-> y < z).
Proof.
intros He. unfold linear_force. assert (Hp : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He).
unfold Rdiv. split; intros H; nra.
Qed.

(** The equation of the deviation in t (paper, modelSysDev), as a first-order chain, for t < tm (+oo allowed) *)
Definition dev_chain (tm : Rbar) (a1 a3 eps : R) (b0 b1 b2 b3 : R -> R) : Prop :=
  (forall t : R, Rbar_lt t tm -> is_derive b0 t (b1 t)) /\ (forall t : R, Rbar_lt t tm -> is_derive b1 t (b2 t)) /\
  (forall t : R, Rbar_lt t tm -> is_derive b2 t (b3 t)) /\
  (forall t : R, Rbar_lt t tm -> is_derive b3 t ((a3 * b0 t - a1 * t * b1 t + eps * ((a3 - a1) * b1 t - a1 * t * b2 t)
      - 2 * eps ^ 2 * b3 t) / eps ^ 3)).

Section Mech.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha3 : a3 <> 0.
Hypothesis Ha13 : a1 <> a3.
Hypothesis Heps : 0 < eps.

Section Recover.
Variables b0 b1 b2 b3 : R -> R.

(** trivial solution + recovery formulas (modelSysDevRecoverY-LN). NB zbar = + eps^2 a2/(a1 - a3). *)
Definition lbar : R := a2 / (a3 - a1).

Definition rec_p (t : R) : R := a1 * t.

Definition rec_b (t : R) : R := a2 / (a1 - a3) * a1 * t + b0 t.

Definition rec_y (t : R) : R := 2 * (eps ^ 2 * a2 / (a1 - a3))
  + (eps ^ 2 * (a3 * b0 t - a1 * t * b1 t + 2 * b1 t) - eps ^ 3 * b2 t - eps ^ 4 * b3 t) / a3.

Definition rec_v (t : R) : R :=
  (- eps * (a3 * b0 t - a1 * t * b1 t) + 2 * eps ^ 2 * b2 t + eps ^ 3 * b3 t) / a3.

Definition rec_z (t : R) : R := eps ^ 2 * a2 / (a1 - a3)
  + (eps ^ 2 * (a3 * b0 t - a1 * t * b1 t + b1 t) - eps ^ 3 * b2 t - eps ^ 4 * b3 t) / a3.

Definition rec_l (t : R) : R := lbar - b1 t / a3.

Lemma rec_force t : linear_force eps (rec_y t) (rec_z t) = rec_l t.
Proof. unfold linear_force, rec_y, rec_z, rec_l, lbar. field. repeat split; try lra. Qed.

Theorem recover tm : dev_chain tm a1 a3 eps b0 b1 b2 b3 ->
  forall t : R, Rbar_lt t tm -> model_at a1 a2 a3 eps linear_force rec_p rec_b rec_y rec_v rec_z t.
Proof.
intros (D0 & D1 & D2 & D3) t Ht.
specialize (D0 t Ht). specialize (D1 t Ht). specialize (D2 t Ht). specialize (D3 t Ht).
assert (X0 : ex_derive b0 t) by (eexists; apply D0).
assert (X1 : ex_derive b1 t) by (eexists; apply D1).
assert (X2 : ex_derive b2 t) by (eexists; apply D2).
assert (X3 : ex_derive b3 t) by (eexists; apply D3).
assert (E0 := is_derive_unique _ _ _ D0).
assert (E1 := is_derive_unique _ _ _ D1).
assert (E2 := is_derive_unique _ _ _ D2).
assert (E3 := is_derive_unique _ _ _ D3).
unfold model_at. rewrite rec_force.
refine (conj _ (conj _ (conj _ (conj _ _)))).
- unfold rec_p. auto_derive; auto; ring.
- unfold rec_b, rec_l, lbar. auto_derive; auto.
  replace (Derive (fun x => b0 x) t) with (Derive b0 t) by reflexivity. rewrite E0. field. split; lra.
- unfold rec_y, rec_v. auto_derive. repeat split; auto.
  change (fun x => b0 x) with b0. change (fun x => b1 x) with b1. change (fun x => b2 x) with b2.
  change (fun x => b3 x) with b3.
  rewrite E0, E1, E2, E3. field. repeat split; lra.
- unfold rec_v, rec_b, rec_p, rec_l, lbar. auto_derive. repeat split; auto.
  change (fun x => b0 x) with b0. change (fun x => b1 x) with b1. change (fun x => b2 x) with b2.
  change (fun x => b3 x) with b3.
  rewrite E0, E1, E2, E3. field. repeat split; lra.
- unfold rec_z, rec_l, lbar. auto_derive. repeat split; auto.
  change (fun x => b0 x) with b0. change (fun x => b1 x) with b1. change (fun x => b2 x) with b2.
  change (fun x => b3 x) with b3.
  rewrite E0, E1, E2, E3. field. repeat split; lra.
Qed.

End Recover.

(** Converse: in contact, with the origin of time at p = 0, every solution is of this form. *)
Theorem recover_converse (tm : Rbar) (p b y v z : R -> R) : (forall t : R, Rbar_lt t tm -> p t = a1 * t) ->
  (forall t : R, Rbar_lt t tm -> model_at a1 a2 a3 eps linear_force p b y v z t) ->
  exists b0 b1 b2 b3, dev_chain tm a1 a3 eps b0 b1 b2 b3 /\
    (forall t : R, Rbar_lt t tm -> p t = rec_p t /\ b t = rec_b b0 t /\ y t = rec_y b0 b1 b2 b3 t /\
      v t = rec_v b0 b1 b2 b3 t /\ z t = rec_z b0 b1 b2 b3 t) /\
    (forall t, b0 t = b t - a2 / (a1 - a3) * a1 * t /\
      b1 t = a2 - a3 * ((z t - y t) / eps ^ 2) - a2 / (a1 - a3) * a1 /\
      b2 t = - a3 * (((y t - 2 * z t) / eps - v t) / eps ^ 2) /\
      b3 t = - a3 * (((v t - 2 * ((y t - 2 * z t) / eps)) / eps
        - (b t + a1 * t * ((z t - y t) / eps ^ 2))) / eps ^ 2)).
Proof.
intros Ep H.
set (b0 := fun t => b t - a2 / (a1 - a3) * a1 * t).
set (b1 := fun t => a2 - a3 * ((z t - y t) / eps ^ 2) - a2 / (a1 - a3) * a1).
set (b2 := fun t => - a3 * (((y t - 2 * z t) / eps - v t) / eps ^ 2)).
set (b3 := fun t => - a3 * (((v t - 2 * ((y t - 2 * z t) / eps)) / eps
    - (b t + a1 * t * ((z t - y t) / eps ^ 2))) / eps ^ 2)).
exists b0, b1, b2, b3.
assert (DD : forall t : R, Rbar_lt t tm -> is_derive b t (a2 - a3 * ((z t - y t) / eps ^ 2)) /\
  is_derive y t (v t) /\ is_derive v t (b t + a1 * t * ((z t - y t) / eps ^ 2)) /\
  is_derive z t ((y t - 2 * z t) / eps)).
{ intros t Ht. destruct (H t Ht) as (_ & Db & Dy & Dv & D).
  rewrite (Ep t Ht) in Dv. refine (conj Db (conj Dy (conj Dv _))).
  apply (is_derive_ext (fun s => / eps * (eps * z s))).
  { intros s. change (/ eps * (eps * z s) = z s). field; lra. }
  replace ((y t - 2 * z t) / eps) with (/ eps * (- z t - eps ^ 2 * linear_force eps (y t) (z t))).
  2: { unfold linear_force. field; lra. }
  apply (is_derive_scal (fun s => eps * z s)), D. }
split.
- refine (conj _ (conj _ (conj _ _))); intros t Ht; destruct (DD t Ht) as (Db & Dy & Dv & Dz);
  assert (Xb : ex_derive b t) by (eexists; apply Db); assert (Xy : ex_derive y t) by (eexists; apply Dy);
  assert (Xv : ex_derive v t) by (eexists; apply Dv); assert (Xz : ex_derive z t) by (eexists; apply Dz);
  assert (Eb := is_derive_unique _ _ _ Db); assert (Ey := is_derive_unique _ _ _ Dy);
  assert (Ev := is_derive_unique _ _ _ Dv); assert (Ez := is_derive_unique _ _ _ Dz).
  + unfold b0, b1. auto_derive; auto. change (fun x => b x) with b. rewrite Eb. ring.
  + unfold b1, b2. auto_derive; auto. change (fun x => y x) with y. change (fun x => z x) with z.
    rewrite Ey, Ez. field; lra.
  + unfold b2, b3. auto_derive; auto.
    change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => v x) with v.
    rewrite Ey, Ez, Ev. field; lra.
  + unfold b0, b1, b2, b3. auto_derive. repeat split; auto.
    change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => v x) with v.
    change (fun x => b x) with b.
    rewrite Ey, Ez, Ev, Eb. field. repeat split; lra.
- split; intros t.
  2: { unfold b0, b1, b2, b3. repeat split. }
  intros Ht. unfold rec_p, rec_b, rec_y, rec_v, rec_z, b0, b1, b2, b3. rewrite (Ep t Ht).
  refine (conj _ (conj _ (conj _ (conj _ _)))); field; repeat split; lra.
Qed.

End Mech.

(** ** The slow solutions of the mechanism: trivial + C times F_beta(t/eps; -a1 eps) *)
Section SlowMech.
Variables (a1 a2 a3 eps C : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Let beta := a3 / a1.
Let e := - a1 * eps.
Hypothesis Hbeta : not_nat (a3 / a1).

Definition hb (n : nat) (t : R) : R := C * Derive_n (Fe (- a1 * eps) (a3 / a1)) n (t / eps) / eps ^ n.

Lemma He' : 0 < - a1 * eps.
Proof. nra. Qed.

Lemma beta_pos : 0 < a3 / a1.
Proof. replace (a3 / a1) with ((- a3) / (- a1)) by (field; lra). apply Rdiv_lt_0_compat; lra. Qed.

Lemma a13 : a1 <> a3.
Proof. intros E. apply (Hbeta 1%nat). rewrite <- E. simpl. field; lra. Qed.

Lemma hb_derive n t : is_derive (hb n) t (hb (S n) t).
Proof.
unfold hb.
assert (D : is_derive (Derive_n (Fe (- a1 * eps) (a3 / a1)) n) (t / eps)
   (Derive_n (Fe (- a1 * eps) (a3 / a1)) (S n) (t / eps))).
{ apply (Derive_correct (Derive_n (Fe (- a1 * eps) (a3 / a1)) n)).
  exact (Fe_ex_derive_n _ He' _ (S n) (t / eps) Hbeta). }
set (f := Derive_n (Fe (- a1 * eps) (a3 / a1)) n) in *.
set (l := Derive_n (Fe (- a1 * eps) (a3 / a1)) (S n) (t / eps)) in *.
assert (Hn : eps ^ n <> 0) by (apply pow_nonzero; lra).
apply (is_derive_ext (fun t => C / eps ^ n * f (t / eps))).
{ intros s. change (C / eps ^ n * f (s / eps) = C * f (s / eps) / eps ^ n). field; auto. }
replace (C * l / eps ^ S n) with (C / eps ^ n * (/ eps * l)) by (simpl; field; split; auto; lra).
apply (is_derive_scal (fun t => f (t / eps))).
apply (is_derive_comp f (fun t => t / eps) t l (/ eps)); auto.
auto_derive; auto. field; lra.
Qed.

Lemma hb_chain tm : dev_chain tm a1 a3 eps (hb 0) (hb 1) (hb 2) (hb 3).
Proof.
refine (conj (fun t _ => hb_derive 0 t) (conj (fun t _ => hb_derive 1 t) (conj (fun t _ => hb_derive 2 t) _))).
intros t _.
assert (H := proj2 (Fe_ode (- a1 * eps) He' (a3 / a1) Hbeta) (t / eps)).
set (F := Fe (- a1 * eps) (a3 / a1)) in *.
assert (E4 : Derive_n F 4 (t / eps) = - a1 * eps * (- (a3 / a1) * F (t / eps) + t / eps * Derive F (t / eps)
   + (1 - a3 / a1) * Derive F (t / eps) + t / eps * Derive_n F 2 (t / eps)) - 2 * Derive_n F 3 (t / eps)).
{ replace (Derive_n F 4 (t / eps)) with (- a1 * eps * (1 / (- a1 * eps) * Derive_n F 4 (t / eps))) by (field; lra).
  replace (1 / (- a1 * eps) * Derive_n F 4 (t / eps)) with
   (- (a3 / a1) * F (t / eps) + t / eps * Derive F (t / eps) + (1 - a3 / a1) * Derive F (t / eps) +
     t / eps * Derive_n F 2 (t / eps) - 2 / (- a1 * eps) * Derive_n F 3 (t / eps)) by lra.
  field. lra. }
replace ((a3 * hb 0 t - a1 * t * hb 1 t + eps * ((a3 - a1) * hb 1 t - a1 * t * hb 2 t) - 2 * eps ^ 2 * hb 3 t)
  / eps ^ 3)
  with (hb 4 t).
{ apply hb_derive. }
unfold hb. fold F. rewrite E4.
change (Derive_n F 0 (t / eps)) with (F (t / eps)). change (Derive_n F 1 (t / eps)) with (Derive F (t / eps)).
field. split; lra.
Qed.

Definition sol_p (t : R) : R := rec_p a1 t.

Definition sol_b (t : R) : R := rec_b a1 a2 a3 (hb 0) t.

Definition sol_y (t : R) : R := rec_y a1 a2 a3 eps (hb 0) (hb 1) (hb 2) (hb 3) t.

Definition sol_v (t : R) : R := rec_v a1 a3 eps (hb 0) (hb 1) (hb 2) (hb 3) t.

Definition sol_z (t : R) : R := rec_z a1 a2 a3 eps (hb 0) (hb 1) (hb 2) (hb 3) t.

(** the contact force *)
Definition sol_l (t : R) : R := a2 / (a3 - a1) + C / (- a3 * eps) * Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps).

Lemma sol_force t : linear_force eps (sol_y t) (sol_z t) = sol_l t.
Proof.
unfold sol_y, sol_z. rewrite (rec_force a1 a2 a3 eps ltac:(lra) a13 Heps).
unfold rec_l, lbar, sol_l, hb.
change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)).
assert (H := a13). field. repeat split; lra.
Qed.

(** They solve the contact equations for all t ... *)
Theorem sol_contact t : model_at a1 a2 a3 eps linear_force sol_p sol_b sol_y sol_v sol_z t.
Proof.
apply (recover a1 a2 a3 eps ltac:(lra) a13 Heps (hb 0) (hb 1) (hb 2) (hb 3) p_infty (hb_chain p_infty)). exact I.
Qed.

(** ... and the full equations, with compl2, as long as the force is not negative. *)
Theorem sol_model t : 0 <= sol_l t -> model_at a1 a2 a3 eps contact_force sol_p sol_b sol_y sol_v sol_z t.
Proof.
intros H. assert (E : contact_force eps (sol_y t) (sol_z t) = linear_force eps (sol_y t) (sol_z t)).
{ apply contact_force_in_contact; auto. rewrite sol_force; auto. }
assert (M := sol_contact t). unfold model_at in *. rewrite E. exact M.
Qed.

Lemma sol_l_derive t : is_derive sol_l t (C / (- a3 * eps ^ 2) * Derive_n (Fe (- a1 * eps) (a3 / a1)) 2 (t / eps)).
Proof.
apply (is_derive_ext (fun t => a2 / (a3 - a1) - / a3 * hb 1 t)).
{ intros s. unfold sol_l, hb.
  change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (s / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (s / eps)).
  match goal with |- ?x = ?y => change (@eq R x y) end. assert (H := a13). field. repeat split; lra. }
replace (C / (- a3 * eps ^ 2) * Derive_n (Fe (- a1 * eps) (a3 / a1)) 2 (t / eps)) with (0 - / a3 * hb 2 t).
2: { unfold hb. field. split; lra. }
apply (is_derive_minus (fun _ => a2 / (a3 - a1)) (fun t => / a3 * hb 1 t)).
apply (is_derive_const (a2 / (a3 - a1))).
apply (is_derive_scal (hb 1)), hb_derive.
Qed.

Lemma k_pos : 0 < / (- a3 * eps).
Proof. apply Rinv_0_lt_compat. nra. Qed.

(** *** The side rule at every eps, every non-integer beta > 0 *)
Theorem side_rule_up : 0 < C * Gamma (- (a3 / a1)) ->
  forall M, exists T, forall t, T <= t -> M <= sol_l t.
Proof.
intros HC M.
assert (Hg := not_nat_Gamma (a3 / a1) Hbeta).
set (G := Gamma (- (a3 / a1))) in *. set (lb := a2 / (a3 - a1)).
set (q := C / G * / (- a3 * eps)).
assert (Hq : 0 < q).
{ unfold q. apply Rmult_lt_0_compat; [|apply k_pos].
  replace (C / G) with (C * G * (/ G) ^ 2) by (field; auto).
  apply Rmult_lt_0_compat; auto. apply pow2_gt_0, Rinv_neq_0_compat, Hg. }
destruct (Fe_right _ He' (a3 / a1) 1 Hbeta ((M - lb) / q)) as (T & HT & H).
exists (eps * T). intros t Ht.
assert (Ht' : T <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). auto. }
specialize (H (t / eps) Ht'). fold G in H.
change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in H.
unfold sol_l. fold lb. set (F := Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in *.
replace (C / (- a3 * eps) * F) with (q * (G * F)) by (unfold q; field; repeat split; auto; lra).
apply (Rmult_le_compat_l q) in H; [|lra].
replace (q * ((M - lb) / q)) with (M - lb) in H by (field; lra). lra.
Qed.

Theorem side_rule_down : C * Gamma (- (a3 / a1)) < 0 ->
  forall M, exists T, forall t, T <= t -> sol_l t <= M.
Proof.
intros HC M.
assert (Hg := not_nat_Gamma (a3 / a1) Hbeta).
set (G := Gamma (- (a3 / a1))) in *. set (lb := a2 / (a3 - a1)).
set (q := - C / G * / (- a3 * eps)).
assert (Hq : 0 < q).
{ unfold q. apply Rmult_lt_0_compat; [|apply k_pos].
  replace (- C / G) with (- (C * G) * (/ G) ^ 2) by (field; auto).
  apply Rmult_lt_0_compat; try lra. apply pow2_gt_0, Rinv_neq_0_compat, Hg. }
destruct (Fe_right _ He' (a3 / a1) 1 Hbeta ((lb - M) / q)) as (T & HT & H).
exists (eps * T). intros t Ht.
assert (Ht' : T <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). auto. }
specialize (H (t / eps) Ht'). fold G in H.
change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in H.
unfold sol_l. fold lb. set (F := Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in *.
replace (C / (- a3 * eps) * F) with (- (q * (G * F))) by (unfold q; field; repeat split; auto; lra).
apply (Rmult_le_compat_l q) in H; [|lra].
replace (q * ((lb - M) / q)) with (lb - M) in H by (field; lra). lra.
Qed.

(** *** 0 < beta < 2: the force is strictly monotone *)
Lemma sol_l_slope t : a3 / a1 < 2 -> exists q, 0 < q /\
  C / (- a3 * eps ^ 2) * Derive_n (Fe (- a1 * eps) (a3 / a1)) 2 (t / eps) = q * (C * Gamma (- (a3 / a1))).
Proof.
intros H2.
assert (Hg := not_nat_Gamma (a3 / a1) Hbeta).
assert (HS := Fe_sign _ He' (a3 / a1) 2 Hbeta ltac:(simpl; lra) (t / eps)).
set (G := Gamma (- (a3 / a1))) in *. set (F := Derive_n (Fe (- a1 * eps) (a3 / a1)) 2 (t / eps)) in *.
exists (/ (- a3 * eps ^ 2) * (G * F) * (/ G) ^ 2). split.
- apply Rmult_lt_0_compat. apply Rmult_lt_0_compat; auto.
  apply Rinv_0_lt_compat, Rmult_lt_0_compat. lra. apply pow_lt, Heps.
  apply pow2_gt_0, Rinv_neq_0_compat, Hg.
- field. repeat split; auto; lra.
Qed.

Theorem sol_l_increasing : a3 / a1 < 2 -> 0 < C * Gamma (- (a3 / a1)) ->
  forall s t, s < t -> sol_l s < sol_l t.
Proof.
intros H2 HC s t Hst.
destruct (mvt_open _ _ s t Hst (fun u _ => sol_l_derive u)) as (c & _ & E).
destruct (sol_l_slope c H2) as (q & Hq & Eq). rewrite Eq in E.
assert (0 < q * (C * Gamma (- (a3 / a1))) * (t - s)).
{ apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto. }
lra.
Qed.

Theorem sol_l_decreasing : a3 / a1 < 2 -> C * Gamma (- (a3 / a1)) < 0 ->
  forall s t, s < t -> sol_l t < sol_l s.
Proof.
intros H2 HC s t Hst.
destruct (mvt_open _ _ s t Hst (fun u _ => sol_l_derive u)) as (c & _ & E).
destruct (sol_l_slope c H2) as (q & Hq & Eq). rewrite Eq in E.
assert (0 < q * - (C * Gamma (- (a3 / a1))) * (t - s)).
{ apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; lra. }
lra.
Qed.

Lemma sol_l_cont : continuity sol_l.
Proof. exact (derive_continuity _ _ sol_l_derive). Qed.

(** Impact without collision at every eps: Cases I and II (0 < beta < 1, C < 0), and case III with 1 < beta < 2, C > 0;
    any a2. Once the contact force is not negative it stays positive, increases, and tends to +oo:
    contact is never lost. *)
Theorem IWC_model : (a3 / a1 < 1 /\ C < 0) \/ (1 < a3 / a1 < 2 /\ 0 < C) ->
  (forall s t, s < t -> sol_l s < sol_l t) /\
  (forall M, exists T, forall t, T <= t -> M <= sol_l t) /\
  (forall t0, 0 <= sol_l t0 ->
     (forall t, t0 < t -> 0 < sol_l t /\ sol_y t < sol_z t) /\
     (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force sol_p sol_b sol_y sol_v sol_z t)).
Proof.
intros Hc. assert (HB := beta_pos).
assert (HC : 0 < C * Gamma (- (a3 / a1)) /\ a3 / a1 < 2).
{ destruct Hc as [[H1 H2]|[H1 H2]]; split; try lra.
  - assert (Gamma (- (a3 / a1)) < 0) by (apply Gamma_neg; lra). nra.
  - assert (0 < Gamma (- (a3 / a1))) by (apply Gamma_12; lra). nra. }
destruct HC as [HC H2].
split; [|split].
- exact (sol_l_increasing H2 HC).
- exact (side_rule_up HC).
- intros t0 H0. split; intros t Ht.
  + assert (H := sol_l_increasing H2 HC t0 t Ht).
    assert (Hp : 0 < sol_l t) by lra. split; auto.
    apply (linear_force_pos eps); auto. rewrite sol_force; auto.
  + apply sol_model. destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|<-]; auto.
    assert (H := sol_l_increasing H2 HC t0 t Hl). lra.
Qed.

(** The other side: the force decreases strictly to -oo. If it is positive at some time, there is exactly one
    later instant of lift-off. *)
Theorem lift_off_model : (a3 / a1 < 1 /\ 0 < C) \/ (1 < a3 / a1 < 2 /\ C < 0) ->
  (forall s t, s < t -> sol_l t < sol_l s) /\
  (forall t0, 0 < sol_l t0 -> exists t1, t0 < t1 /\ sol_l t1 = 0 /\
     (forall t, t < t1 -> 0 < sol_l t) /\ (forall t, t1 < t -> sol_l t < 0)).
Proof.
intros Hc. assert (HB := beta_pos).
assert (HC : C * Gamma (- (a3 / a1)) < 0 /\ a3 / a1 < 2).
{ destruct Hc as [[H1 H2]|[H1 H2]]; split; try lra.
  - assert (Gamma (- (a3 / a1)) < 0) by (apply Gamma_neg; lra). nra.
  - assert (0 < Gamma (- (a3 / a1))) by (apply Gamma_12; lra). nra. }
destruct HC as [HC H2].
split.
- exact (sol_l_decreasing H2 HC).
- intros t0 H0. destruct (side_rule_down HC (-1)) as (T & HT).
  set (T' := Rmax T (t0 + 1)).
  assert (HT' := HT T' (Rmax_l _ _)).
  assert (Ht0 : t0 < T') by (generalize (Rmax_r T (t0 + 1)); unfold T'; lra).
  destruct (IVT_cor sol_l t0 T' sol_l_cont ltac:(lra)) as (t1 & Ht1 & E1).
  { nra. }
  assert (Hne : t0 <> t1) by (intros E; rewrite E in H0; lra).
  exists t1. split; [lra|]. split; auto. split; intros t Ht; rewrite <- E1;
   [exact (sol_l_decreasing H2 HC t t1 Ht)|exact (sol_l_decreasing H2 HC t1 t Ht)].
Qed.

(** *** 0 < beta < 1: the sign of the force for all time *)
Theorem force_sign : a3 / a1 < 1 ->
  (* Case II (a2 > 0; also a2 = 0, C <> 0): never zero, contact for all t *)
  (0 <= a2 -> C <= 0 -> a2 <> 0 \/ C <> 0 -> forall t, 0 < sol_l t) /\
  (a2 <= 0 -> 0 <= C -> forall t, sol_l t <= 0).
Proof.
intros H1. assert (HB := beta_pos).
assert (Hd : 0 < a3 - a1).
{ assert (a3 / a1 * a1 = a3) by (field; lra). nra. }
assert (HF : forall t, Derive (Fe (- a1 * eps) (a3 / a1)) t < 0).
{ intros t. apply (IWC_eps (- a1 * eps) He' (a3 / a1) ltac:(lra) 1 t). lia. }
assert (Hi : 0 < / (a3 - a1)) by (apply Rinv_0_lt_compat; auto).
assert (Hk := k_pos).
split.
- intros A B D t. unfold sol_l. specialize (HF (t / eps)).
  set (F := Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in *.
  replace (C / (- a3 * eps) * F) with (/ (- a3 * eps) * ((- C) * (- F))) by (field; lra).
  assert (0 <= a2 / (a3 - a1)) by (apply Rmult_le_pos; lra).
  assert (0 <= (- C) * (- F)) by (apply Rmult_le_pos; lra).
  assert (0 <= / (- a3 * eps) * ((- C) * (- F))) by (apply Rmult_le_pos; lra).
  destruct D as [D|D].
  + assert (0 < a2 / (a3 - a1)) by (apply Rmult_lt_0_compat; lra). lra.
  + assert (0 < (- C) * (- F)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < / (- a3 * eps) * ((- C) * (- F))) by (apply Rmult_lt_0_compat; lra). lra.
- intros A B t. unfold sol_l. specialize (HF (t / eps)).
  set (F := Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in *.
  replace (C / (- a3 * eps) * F) with (- (/ (- a3 * eps) * (C * (- F)))) by (field; lra).
  assert (0 <= C * (- F)) by (apply Rmult_le_pos; lra).
  assert (0 <= / (- a3 * eps) * (C * (- F))) by (apply Rmult_le_pos; lra).
  assert (0 <= - a2 * / (a3 - a1)) by (apply Rmult_le_pos; lra).
  unfold Rdiv at 1. lra.
Qed.

End SlowMech.
