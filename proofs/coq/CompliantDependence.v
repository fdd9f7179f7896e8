(** * The compliant model: how a motion depends on its state

    The force with compl2 is Lipschitz. So the difference of two motions grows at most exponentially ([motions_close], p
    may differ too), and a motion is determined by its state ([forward_unique]). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus Gronwall.
Open Scope R_scope.

Lemma contact_force_lipschitz eps y z y' z' : 0 < eps ->
  Rabs (contact_force eps y z - contact_force eps y' z') <= / eps ^ 2 * (Rabs (y - y') + Rabs (z - z')).
Proof.
intros He. assert (Hi : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He).
assert (E : forall y z, contact_force eps y z = / eps ^ 2 * Rmax 0 (z - y)).
{ intros y0 z0. unfold contact_force. destruct (Rlt_dec y0 z0) as [H|H].
  - rewrite Rmax_right by lra. unfold Rdiv; ring.
  - rewrite Rmax_left by lra. ring. }
rewrite !E, <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (/ eps ^ 2)) by lra.
apply Rmult_le_compat_l. lra.
unfold Rmax. destruct (Rle_dec 0 (z - y)); destruct (Rle_dec 0 (z' - y')); unfold Rabs;
 repeat destruct Rcase_abs; lra.
Qed.

Section Dependence.
Variables (a1 a2 a3 eps : R).
Hypothesis Heps : 0 < eps.

Lemma prod_lam (q X Y Z L : R) : 0 <= q -> Rabs L <= q * (Rabs Y + Rabs Z) ->
  Rabs (2 * X * L) <= q * (2 * X ^ 2 + Y ^ 2 + Z ^ 2).
Proof.
intros Hq HL. rewrite Rabs_mult.
apply Rle_trans with (Rabs (2 * X) * (q * (Rabs Y + Rabs Z))).
- apply Rmult_le_compat_l; auto using Rabs_pos.
- replace (Rabs (2 * X) * (q * (Rabs Y + Rabs Z))) with (q * (Rabs (2 * X * Y) + Rabs (2 * X * Z))).
  2: { rewrite !(Rabs_mult (2 * X)). ring. }
  apply Rmult_le_compat_l; auto.
  assert (H1 := two_ab X Y). assert (H2 := two_ab X Z). lra.
Qed.

(** Two motions: the difference of their states grows at most exponentially, with a constant that does not depend on
    them but through bounds. *)
Lemma motions_close (p b y v z p' b' y' v' z' : R -> R) (t0 te P eta : R) :
  (forall t, t0 <= t <= te -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  (forall t, t0 <= t <= te -> model_at a1 a2 a3 eps contact_force p' b' y' v' z' t) ->
  (forall t, t0 <= t <= te -> Rabs (p t) <= P) ->
  (forall t, t0 <= t <= te -> ((p t - p' t) * contact_force eps (y' t) (z' t)) ^ 2 <= eta) ->
  let E t := (b t - b' t) ^ 2 + (y t - y' t) ^ 2 + (v t - v' t) ^ 2 + (z t - z' t) ^ 2 in
  forall t, t0 <= t <= te ->
  E t + eta <= (E t0 + eta) * exp ((2 * Rabs a3 * / eps ^ 2 + 3 + 2 * P * / eps ^ 2 + 3 / eps + 2 * eps * / eps ^ 2)
    * (t - t0)).
Proof.
intros H H' HP Heta E t Ht.
set (q := / eps ^ 2).
assert (Hq : 0 < q) by (apply Rinv_0_lt_compat, pow_lt, Heps).
set (L := fun s => contact_force eps (y s) (z s) - contact_force eps (y' s) (z' s)).
set (g := fun s => (p s - p' s) * contact_force eps (y' s) (z' s)).
assert (HL : forall s, Rabs (L s) <= q * (Rabs (y s - y' s) + Rabs (z s - z' s))).
{ intros s. apply contact_force_lipschitz, Heps. }
set (E' := fun s => 2 * (b s - b' s) * (- a3 * L s) + 2 * (y s - y' s) * (v s - v' s)
   + 2 * (v s - v' s) * ((b s - b' s) + p s * L s + g s) + 2 * (z s - z' s)
       * (/ eps * (- (z s - z' s) - eps ^ 2 * L s))).
set (K := 2 * Rabs a3 * q + 3 + 2 * P * q + 3 / eps + 2 * eps * q).
assert (Heta0 : 0 <= eta) by (eapply Rle_trans; [apply pow2_ge_0|exact (Heta t Ht)]).
assert (D : forall s, t0 <= s <= te -> is_derive E s (E' s)).
{ intros s Hs.
  destruct (H s Hs) as (_ & Db & Dy & Dv & Dz). destruct (H' s Hs) as (_ & Db' & Dy' & Dv' & Dz').
  assert (Dz1 : is_derive (fun s => z s - z' s) s (/ eps * (- (z s - z' s) - eps ^ 2 * L s))).
  { apply (is_derive_ext (fun s => / eps * (eps * z s - eps * z' s))).
    { intros u. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
    replace (- (z s - z' s) - eps ^ 2 * L s) with
      ((- z s - eps ^ 2 * contact_force eps (y s) (z s)) - (- z' s - eps ^ 2 * contact_force eps (y' s) (z' s)))
        by (unfold L; ring).
    apply (is_derive_scal (fun s => eps * z s - eps * z' s)).
    apply (is_derive_minus (fun s => eps * z s) (fun s => eps * z' s)); auto. }
  unfold E, E'. eapply is_derive_val.
  + apply (is_derive_plus (fun s => (b s - b' s) ^ 2 + (y s - y' s) ^ 2 + (v s - v' s) ^ 2) (fun s =>
      (z s - z' s) ^ 2)).
    apply (is_derive_plus (fun s => (b s - b' s) ^ 2 + (y s - y' s) ^ 2) (fun s => (v s - v' s) ^ 2)).
    apply (is_derive_plus (fun s => (b s - b' s) ^ 2) (fun s => (y s - y' s) ^ 2)).
    apply is_derive_pow. exact (is_derive_minus b b' s _ _ Db Db').
    apply is_derive_pow. exact (is_derive_minus y y' s _ _ Dy Dy').
    apply is_derive_pow. exact (is_derive_minus v v' s _ _ Dv Dv').
    apply is_derive_pow. exact Dz1.
  + unfold minus, plus, opp, L, g; simpl. unfold L. ring. }
assert (HE' : forall s, t0 <= s <= te -> E' s <= K * (E s + eta)).
{ intros s Hs.
  specialize (HP s Hs). specialize (HL s). specialize (Heta s Hs). fold (g s) in Heta. unfold E, E', K.
  set (B := b s - b' s) in *. set (Y := y s - y' s) in *. set (V := v s - v' s) in *. set (Z := z s - z' s) in *.
  set (l := L s) in *. set (G := g s) in *. clearbody B Y V Z l G.
  assert (HP0 : 0 <= P) by (generalize (Rabs_pos (p s)); lra).
  assert (QB := prod_lam q B Y Z l (Rlt_le _ _ Hq) HL).
  assert (QV := prod_lam q V Y Z l (Rlt_le _ _ Hq) HL).
  assert (QZ := prod_lam q Z Y Z l (Rlt_le _ _ Hq) HL).
  assert (T1 := Rle_trans _ _ _ (Rle_abs _) (two_ab Y V)). assert (T2 := Rle_trans _ _ _ (Rle_abs _) (two_ab V B)).
  assert (T3 := Rle_trans _ _ _ (Rle_abs _) (two_ab V G)).
  replace (2 * B * (- a3 * l) + 2 * Y * V + 2 * V * (B + p s * l + G) + 2 * Z * (/ eps * (- Z - eps ^ 2 * l)))
    with (- a3 * (2 * B * l) + 2 * Y * V + 2 * V * B + p s * (2 * V * l) + - (2 / eps * Z ^ 2) + - eps * (2 * Z * l)
      + 2 * V * G)
    by (field; lra).
  assert (N1 := pow2_ge_0 B). assert (N2 := pow2_ge_0 Y). assert (N3 := pow2_ge_0 V). assert (N4 := pow2_ge_0 Z).
  set (W := B ^ 2 + Y ^ 2 + V ^ 2 + Z ^ 2).
  assert (R1 : - a3 * (2 * B * l) <= Rabs a3 * (q * (2 * W))).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult, Rabs_Ropp. apply Rmult_le_compat_l; [apply Rabs_pos|].
    eapply Rle_trans; [exact QB|]. apply Rmult_le_compat_l; unfold W; lra. }
  assert (R2 : p s * (2 * V * l) <= P * (q * (2 * W))).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
    eapply Rle_trans; [exact QV|]. apply Rmult_le_compat_l; unfold W; lra. }
  assert (Eq : eps * (q * eps) = 1) by (unfold q; field; lra).
  assert (R3 : - eps * (2 * Z * l) <= eps * (q * (2 * W)) + / eps * Z ^ 2).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq eps) by lra.
    replace (/ eps * Z ^ 2) with (eps * (q * Z ^ 2)) by (unfold q; field; lra).
    rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact QZ|].
    rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; unfold W; lra. }
  assert (Hi : 0 < / eps) by (apply Rinv_0_lt_compat, Heps).
  assert (R4 : / eps * Z ^ 2 <= / eps * W) by (apply Rmult_le_compat_l; unfold W; lra).
  assert (R5 : 0 <= / eps * Z ^ 2) by (apply Rmult_le_pos; lra).
  assert (W0 : 0 <= W) by (unfold W; lra).
  assert (K0 : 0 <= 2 * Rabs a3 * q + 2 + 2 * P * q + 3 / eps + 2 * eps * q).
  { assert (0 <= Rabs a3 * q) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
    assert (0 <= P * q) by (apply Rmult_le_pos; lra). assert (0 < eps * q) by (apply Rmult_lt_0_compat; lra).
    unfold Rdiv. lra. }
  assert (R6 : 0 <= (2 * Rabs a3 * q + 2 + 2 * P * q + 3 / eps + 2 * eps * q) * eta) by (apply Rmult_le_pos; lra).
  assert (R7 : 0 <= / eps * W) by (apply Rmult_le_pos; lra).
  assert (T1W : Y ^ 2 + V ^ 2 + (V ^ 2 + B ^ 2) + V ^ 2 <= 3 * W) by (unfold W; lra).
  unfold Rdiv in *.
  lra. }
assert (G : (E t + eta) * exp (- K * (t - t0)) <= (E t0 + eta) * exp (- K * (t0 - t0))).
{ apply (decr_of_derive (fun s => (E s + eta) * exp (- K * (s - t0))) (fun s => (E' s - K * (E s + eta)) * exp
    (- K * (s - t0))) t0 t (proj1 Ht)).
  - intros s Hs. eapply is_derive_val.
    + apply (is_derive_mult_R (fun s => E s + eta) (fun s => exp (- K * (s - t0))) s (E' s + 0)
        (- K * exp (- K * (s - t0)))).
      apply (is_derive_plus E (fun _ => eta)). apply D; lra. apply (is_derive_const eta).
      auto_derive; auto. unfold Rminus; ring.
    + ring.
  - intros s Hs. specialize (HE' s ltac:(lra)). assert (A := exp_pos (- K * (s - t0))). nra. }
replace (- K * (t0 - t0)) with 0 in G by ring. rewrite exp_0, Rmult_1_r in G.
apply (Rmult_le_compat_r (exp (K * (t - t0)))) in G; [|apply Rlt_le, exp_pos].
rewrite Rmult_assoc, <- exp_plus in G. replace (- K * (t - t0) + K * (t - t0)) with 0 in G by ring.
rewrite exp_0, Rmult_1_r in G. exact G.
Qed.

Theorem forward_unique (p b y v z p' b' y' v' z' : R -> R) (t0 te : R) :
  (forall t, t0 <= t <= te -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  (forall t, t0 <= t <= te -> model_at a1 a2 a3 eps contact_force p' b' y' v' z' t) ->
  p t0 = p' t0 -> b t0 = b' t0 -> y t0 = y' t0 -> v t0 = v' t0 -> z t0 = z' t0 ->
  forall t, t0 <= t <= te -> p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.
Proof.
intros H H' Ip Ib Iy Iv Iz.
assert (sq0 : forall x, x ^ 2 <= 0 -> x = 0).
{ intros x Hx. destruct (Req_dec x 0) as [|Hn]; auto. exfalso. generalize (pow2_gt_0 x Hn). lra. }
assert (Ep : forall t, t0 <= t <= te -> p t = p' t).
{ intros t Ht. apply Rminus_diag_uniq, sq0, Req_le.
  apply (one_step_zero (fun t => (p t - p' t) ^ 2) (fun t => 2 * (a1 - a1) * (p t - p' t)) t0 t 0).
  - intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra.
    destruct (H s ltac:(lra)) as (D & _). destruct (H' s ltac:(lra)) as (D' & _).
    eapply is_derive_val. apply is_derive_pow. apply (is_derive_minus p p' s a1 a1 D D').
    unfold minus, plus, opp; simpl. ring.
  - intros s. apply pow2_ge_0.
  - rewrite Ip. ring.
  - intros s _. rewrite Rminus_eq_0, Rmult_0_r, !Rmult_0_l, Rabs_R0. apply Rle_refl. }
intros t Ht.
assert (HP : forall s, t0 <= s <= t -> Rabs (p s) <= Rabs a1 * (t - t0) + Rabs (p t0)).
{ intros s Hs.
  assert (Hm : Rabs (p s - p t0) <= Rabs a1 * (s - t0)).
  { destruct (MVT_gen p t0 s (fun _ => a1)) as [c [_ Hc]].
    - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply (H x). lra.
    - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra.
      apply continuity_pt_filterlim, (ex_derive_continuous p x). exists a1. apply (H x). lra.
    - rewrite Hc, Rabs_mult, (Rabs_pos_eq (s - t0)) by lra. apply Rle_refl. }
  assert (Hm2 : Rabs a1 * (s - t0) <= Rabs a1 * (t - t0)) by (apply Rmult_le_compat_l; [apply Rabs_pos|lra]).
  replace (p s) with ((p s - p t0) + p t0) by ring.
  eapply Rle_trans. apply Rabs_triang. lra. }
assert (M := motions_close p b y v z p' b' y' v' z' t0 t (Rabs a1 * (t - t0) + Rabs (p t0)) 0
  (fun s Hs => H s ltac:(lra)) (fun s Hs => H' s ltac:(lra)) HP).
cbv beta zeta in M.
specialize (M ltac:(intros s Hs; rewrite (Ep s) by lra; rewrite Rminus_eq_0, Rmult_0_l; right; ring) t ltac:(lra)).
rewrite Ib, Iy, Iv, Iz, !Rminus_eq_0, pow_ne_zero, !Rplus_0_r, Rmult_0_l in M by lia.
assert (N1 := pow2_ge_0 (b t - b' t)). assert (N2 := pow2_ge_0 (y t - y' t)).
assert (N3 := pow2_ge_0 (v t - v' t)). assert (N4 := pow2_ge_0 (z t - z' t)).
repeat split.
- apply Ep, Ht.
- apply Rminus_diag_uniq, sq0; lra.
- apply Rminus_diag_uniq, sq0; lra.
- apply Rminus_diag_uniq, sq0; lra.
- apply Rminus_diag_uniq, sq0; lra.
Qed.

End Dependence.
