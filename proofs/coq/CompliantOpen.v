(** * The compliant model: an open set of states from which contact is never lost

    0 < beta < 1, t >= 0: d = force - mean satisfies eps^3 d'''' = (a3 - a1) d + (-a1 t + eps (a3 - 2 a1)) d' - eps a1 t
    d'' - 2 eps^2 d''', whose coefficients but the last are >= 0: {d, d', d'', d''' > 0} is forward invariant, contact
    included, by induction along the time axis. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus LaplaceIntegral Family CompliantKernel CompliantIntegral
  CompliantSlow
  CompliantMechanism.
Open Scope R_scope.

Section Open.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha13 : a1 < a3.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Variables p b y v z : R -> R.

Definition d0 (t : R) : R := (z t - y t) / eps ^ 2 - a2 / (a3 - a1).

Definition d1 (t : R) : R := ((y t - 2 * z t) / eps - v t) / eps ^ 2.

Definition d2 (t : R) : R :=
  ((v t - 2 * ((y t - 2 * z t) / eps)) / eps - (b t + a1 * t * ((z t - y t) / eps ^ 2))) / eps ^ 2.

Definition d3 (t : R) : R :=
  ((b t + a1 * t * ((z t - y t) / eps ^ 2) - 2 * ((v t - 2 * ((y t - 2 * z t) / eps)) / eps)) / eps
   - (a2 - a3 * ((z t - y t) / eps ^ 2) + a1 * ((z t - y t) / eps ^ 2) + a1 * t * d1 t)) / eps ^ 2.

Variable t0 : R.
Hypothesis Ht0 : 0 <= t0.
Hypothesis Hp : forall t, t0 <= t -> p t = a1 * t.
Hypothesis H : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.

Lemma st_ex t : t0 <= t -> ex_derive b t /\ ex_derive y t /\ ex_derive v t /\ ex_derive z t.
Proof.
intros Ht. destruct (H t Ht) as (_ & Db & Dy & Dv & Dz).
refine (conj (ex_intro _ _ Db) (conj (ex_intro _ _ Dy) (conj (ex_intro _ _ Dv) _))).
exists (/ eps * (- z t - eps ^ 2 * contact_force eps (y t) (z t))).
apply (is_derive_ext (fun s => / eps * (eps * z s))).
{ intros s. change (/ eps * (eps * z s) = z s). field; lra. }
apply (is_derive_scal (fun s => eps * z s)), Dz.
Qed.

Lemma d_ex t : t0 <= t -> ex_derive d0 t /\ ex_derive d1 t /\ ex_derive d2 t /\ ex_derive d3 t.
Proof.
intros Ht. destruct (st_ex t Ht) as (Xb & Xy & Xv & Xz).
unfold d0, d1, d2, d3, d1. repeat split; auto_derive; repeat split; auto.
Qed.

Lemma d_derive t : t0 <= t -> y t < z t ->
  is_derive d0 t (d1 t) /\ is_derive d1 t (d2 t) /\ is_derive d2 t (d3 t) /\
  is_derive d3 t (((a3 - a1) * d0 t + (- a1 * t + eps * (a3 - 2 * a1)) * d1 t + eps * (- a1 * t) * d2 t
     - 2 * eps ^ 2 * d3 t) / eps ^ 3).
Proof.
intros Ht Hc. destruct (H t Ht) as (_ & Db & Dy & Dv & Dz).
rewrite (Hp t Ht) in Dv.
assert (El : contact_force eps (y t) (z t) = (z t - y t) / eps ^ 2).
{ unfold contact_force. destruct (Rlt_dec (y t) (z t)); auto; lra. }
rewrite El in Db, Dv, Dz.
assert (Dz' : is_derive z t ((y t - 2 * z t) / eps)).
{ apply (is_derive_ext (fun s => / eps * (eps * z s))).
  { intros s. change (/ eps * (eps * z s) = z s). field; lra. }
  replace ((y t - 2 * z t) / eps) with (/ eps * (- z t - eps ^ 2 * ((z t - y t) / eps ^ 2))) by (field; lra).
  apply (is_derive_scal (fun s => eps * z s)), Dz. }
destruct (st_ex t Ht) as (Xb & Xy & Xv & Xz).
assert (Eb := is_derive_unique _ _ _ Db). assert (Ey := is_derive_unique _ _ _ Dy).
assert (Ev := is_derive_unique _ _ _ Dv). assert (Ez := is_derive_unique _ _ _ Dz').
refine (conj _ (conj _ (conj _ _))).
- unfold d0, d1. auto_derive; auto. change (fun x => y x) with y. change (fun x => z x) with z.
  rewrite Ey, Ez. field; repeat split; lra.
- unfold d1, d2. auto_derive; auto.
  change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => v x) with v.
  rewrite Ey, Ez, Ev. field; lra.
- unfold d2, d3, d1. auto_derive; repeat split; auto.
  change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => v x) with v.
  change (fun x => b x) with b.
  rewrite Ey, Ez, Ev, Eb. field; lra.
- unfold d3, d0, d1, d2. auto_derive; repeat split; auto.
  change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => v x) with v.
  change (fun x => b x) with b.
  rewrite Ey, Ez, Ev, Eb. unfold d1. field; repeat split; lra.
Qed.

Definition Pos (t : R) : Prop := y t < z t /\ 0 < d0 t /\ 0 < d1 t /\ 0 < d2 t /\ 0 < d3 t.

Theorem IWC_open : Pos t0 -> forall t, t0 <= t -> Pos t.
Proof.
intros HP0. apply real_induction; auto.
- intros t Ht HP. destruct (HP t ltac:(lra)) as (P & P0 & P1 & P2 & P3).
  destruct (d_ex t Ht) as (X0 & X1 & X2 & X3). destruct (st_ex t Ht) as (_ & Xy & _ & Xz).
  assert (L : locally t (fun s => 0 < z s - y s)).
  { apply (continuous_pos (fun s => z s - y s)); [|lra]. auto_derive; auto. }
  assert (LL := filter_and _ _ L (filter_and _ _ (continuous_pos _ t X0 P0) (filter_and _ _ (continuous_pos _ t X1 P1)
    (filter_and _ _ (continuous_pos _ t X2 P2) (continuous_pos _ t X3 P3))))).
  destruct LL as [d Hd]. exists d. split. apply cond_pos.
  intros s Hs. destruct (Hd s) as (Q & Q0 & Q1 & Q2 & Q3).
  { unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_pos_eq; lra. }
  repeat split; auto; lra.
- intros t Ht HP.
  destruct HP0 as (A & A0 & A1 & A2 & A3).
  destruct (d_ex t (Rlt_le _ _ Ht)) as (X0 & X1 & X2 & X3).
  assert (G : forall (f f' : R -> R), ex_derive f t -> (forall s, t0 <= s < t -> is_derive f s (f' s) /\ 0 <= f' s) ->
    f t0 <= f t).
  { intros f f' Xf Hf. apply (closed_ge f t0 t (f t0) Ht Xf). intros s Hs.
    apply Ropp_le_cancel. apply (decr_of_derive (fun x => - f x) (fun x => - f' x) t0 s (proj1 Hs)).
    - intros x Hx. apply (is_derive_opp f), Hf. lra.
    - intros x Hx. destruct (Hf x ltac:(lra)). lra. }
  assert (G0 : d0 t0 <= d0 t).
  { apply (G d0 d1 X0). intros s Hs. destruct (HP s Hs) as (P & P0 & P1 & P2 & P3).
    destruct (d_derive s ltac:(lra) P) as (D & _). split; [exact D|lra]. }
  assert (G1 : d1 t0 <= d1 t).
  { apply (G d1 d2 X1). intros s Hs. destruct (HP s Hs) as (P & P0 & P1 & P2 & P3).
    destruct (d_derive s ltac:(lra) P) as (_ & D & _). split; [exact D|lra]. }
  assert (G2 : d2 t0 <= d2 t).
  { apply (G d2 d3 X2). intros s Hs. destruct (HP s Hs) as (P & P0 & P1 & P2 & P3).
    destruct (d_derive s ltac:(lra) P) as (_ & _ & D & _). split; [exact D|lra]. }
  assert (G3 : d3 t0 * exp (2 * t0 / eps) <= d3 t * exp (2 * t / eps)).
  { apply (G (fun s => d3 s * exp (2 * s / eps)) (fun s => ((a3 - a1) * d0 s + (- a1 * s + eps * (a3 - 2 * a1)) * d1 s
       + eps * (- a1 * s) * d2 s) / eps ^ 3 * exp (2 * s / eps))).
    - auto_derive; auto.
    - intros s Hs. destruct (HP s Hs) as (P & P0 & P1 & P2 & P3).
      destruct (d_derive s ltac:(lra) P) as (_ & _ & _ & D). split.
      + eapply is_derive_val.
        * apply (is_derive_mult_R d3 (fun s => exp (2 * s / eps)) s _ (2 / eps * exp (2 * s / eps)) D).
          auto_derive; auto. unfold Rdiv; ring.
        * field. lra.
      + assert (0 <= - a1 * s) by (apply Rmult_le_pos; lra).
        assert (0 <= eps * (a3 - 2 * a1)) by (apply Rmult_le_pos; lra).
        assert (0 <= (a3 - a1) * d0 s) by (apply Rmult_le_pos; lra).
        assert (0 <= (- a1 * s + eps * (a3 - 2 * a1)) * d1 s) by (apply Rmult_le_pos; lra).
        assert (0 <= eps * (- a1 * s) * d2 s) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
        apply Rmult_le_pos; [|apply Rlt_le, exp_pos].
        apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat, pow_lt, Heps. }
  assert (K3 : 0 < d3 t).
  { assert (E1 := exp_pos (2 * t0 / eps)). assert (E2 := exp_pos (2 * t / eps)).
    assert (0 < d3 t0 * exp (2 * t0 / eps)) by (apply Rmult_lt_0_compat; auto).
    apply Rmult_lt_reg_r with (exp (2 * t / eps)); auto. lra. }
  assert (Kc : y t < z t).
  { unfold d0 in G0. assert (He : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, Heps).
    unfold Rdiv in G0. nra. }
  repeat split; auto; lra.
Qed.

(** In Case II (a2 > 0) contact at t0 follows from d0 > 0. The force is then > lbar and strictly increasing for ever. *)
Corollary IWC_open_force : Pos t0 -> forall s t, t0 <= s -> s < t ->
  contact_force eps (y s) (z s) < contact_force eps (y t) (z t).
Proof.
intros HP s t Hs Hst.
assert (Hall := IWC_open HP).
assert (E : forall x, t0 <= x -> contact_force eps (y x) (z x) = d0 x + a2 / (a3 - a1)).
{ intros x Hx. unfold contact_force, d0. destruct (Rlt_dec (y x) (z x)) as [Hl|Hl]. ring.
  exfalso. apply Hl, (Hall x Hx). }
rewrite !E by lra.
destruct (mvt_open d0 d1 s t Hst) as (c & Hc & Em).
{ intros x Hx. apply d_derive. lra. apply (Hall x). lra. }
assert (0 < d1 c) by (apply (Hall c); lra).
assert (0 < d1 c * (t - s)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

End Open.

(** The slow solutions with C < 0 lie inside the open set, at every time at which they are in contact. *)
Theorem slow_in_open (a1 a2 a3 eps C t : R) : a1 < 0 -> a1 < a3 -> a3 < 0 -> 0 < eps -> C < 0 ->
  sol_y a1 a2 a3 eps C t < sol_z a1 a2 a3 eps C t ->
  Pos a1 a2 a3 eps (sol_b a1 a2 a3 eps C) (sol_y a1 a2 a3 eps C) (sol_v a1 a3 eps C) (sol_z a1 a2 a3 eps C) t.
Proof.
intros Ha1 Ha13 Ha3 He HC Hyz.
assert (Hb : 0 < a3 / a1 < 1).
{ split. apply beta_pos; auto. apply Rmult_lt_reg_r with (- a1). lra.
  replace (a3 / a1 * - a1) with (- a3) by (field; lra). lra. }
assert (Hn := not_nat_01 _ Hb).
assert (Hp : forall n, (1 <= n)%nat -> 0 < - / a3 * hb a1 a3 eps C n t).
{ intros n Hn1. unfold hb.
  assert (HF := IWC_eps (- a1 * eps) (He' a1 eps Ha1 He) (a3 / a1) Hb n (t / eps) Hn1).
  set (F := Derive_n (Fe (- a1 * eps) (a3 / a1)) n (t / eps)) in *.
  assert (Hen : 0 < / eps ^ n) by (apply Rinv_0_lt_compat, pow_lt, He).
  replace (- / a3) with (/ - a3) by (field; lra).
  apply Rmult_lt_0_compat. apply Rinv_0_lt_compat; lra.
  apply Rmult_lt_0_compat; auto. nra. }
destruct (hb_chain a1 a3 eps C Ha1 He Hn p_infty) as (_ & _ & _ & D3).
assert (E4 : hb a1 a3 eps C 4 t = (a3 * hb a1 a3 eps C 0 t - a1 * t * hb a1 a3 eps C 1 t
    + eps * ((a3 - a1) * hb a1 a3 eps C 1 t - a1 * t * hb a1 a3 eps C 2 t) - 2 * eps ^ 2 * hb a1 a3 eps C 3 t)
        / eps ^ 3).
{ rewrite <- (is_derive_unique _ _ _ (D3 t I)). symmetry. apply is_derive_unique, hb_derive; auto. }
assert (H1 := Hp 1%nat (le_n _)). assert (H2 := Hp 2%nat ltac:(lia)). assert (H3 := Hp 3%nat ltac:(lia)).
assert (H4 := Hp 4%nat ltac:(lia)). rewrite E4 in H4.
unfold Pos, sol_b, sol_y, sol_v, sol_z in *.
refine (conj Hyz (conj _ (conj _ (conj _ _)))).
- eapply Rlt_le_trans; [exact H1|right]. unfold d0, rec_y, rec_z. field. repeat split; lra.
- eapply Rlt_le_trans; [exact H2|right]. unfold d1, rec_y, rec_z, rec_v. field. repeat split; lra.
- eapply Rlt_le_trans; [exact H3|right]. unfold d2, rec_b, rec_y, rec_z, rec_v. field. repeat split; lra.
- eapply Rlt_le_trans; [exact H4|right]. unfold d3, d1, rec_b, rec_y, rec_z, rec_v. field. repeat split; lra.
Qed.
