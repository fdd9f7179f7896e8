(** * The compliant model: a set of states with p < 0, for every beta, from which contact is never lost

    With w0 = b less its trivial part, ' = eps d/dt: w0' = w1, w1' = w2, w2' = w3, w3' = a3 eps w0 + (-p + eps (a3 -
    a1)) w1 - p w2 - 2 w3 in contact, and w1 is a positive multiple of the force less its mean. In w0, f = w1 - w0, h =
    w2 - w1, k = w3 - w2 - 2 w1 this reads w0' = f + w0, f' = h, h' = k + 2 f + 2 w0 and k' = -3 k + (a combination that
    is > 0 with w0, f, h > 0 if -p >= 6 - 2 a3 eps). So all four stay > 0, and contact with them, by induction along the
    time axis. The slow motions on the side of impact without collision are in the set for all large t. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral CompliantSlow
  CompliantMechanism CompliantExcess CompliantDominance.
Open Scope R_scope.

Section Cone.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Ha13 : a1 <> a3.
Hypothesis Heps : 0 < eps.
Variables p b y v z : R -> R.
Variable t0 : R.
Hypothesis Hp : p t0 <= - (6 - 2 * a3 * eps).
Hypothesis H : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.

Let w (t : R) : R := deviation a1 a2 a3 p b t.
Let d0 (t : R) : R := excess a1 a2 a3 eps y z t.
Let d1 (t : R) : R := excess1 eps y v z t.
Let d2 (t : R) : R := excess2 eps p b y v z t.
Let f (t : R) : R := - a3 * eps * d0 t - w t.
Let h (t : R) : R := eps * d1 t - d0 t.
Let k (t : R) : R := eps ^ 2 * d2 t - eps * d1 t - 2 * d0 t.

Lemma late_state_ex t : t0 <= t -> ex_derive p t /\ ex_derive b t /\ ex_derive y t /\ ex_derive v t /\ ex_derive z t.
Proof. intros Ht. exact (state_ex a1 a2 a3 eps Heps p b y v z contact_force t (H t Ht)). Qed.

Lemma cone_ex t : t0 <= t -> ex_derive w t /\ ex_derive f t /\ ex_derive h t /\ ex_derive k t.
Proof.
intros Ht. destruct (late_state_ex t Ht) as (Xp & Xb & Xy & Xv & Xz).
unfold w, f, h, k, w, d0, d1, d2, deviation, excess, excess1, excess2, force_excess, force_excess1, force_excess2.
repeat split; auto_derive; repeat split; auto.
Qed.

Lemma late_p t : t0 <= t -> p t <= - (6 - 2 * a3 * eps).
Proof.
intros Ht. eapply Rle_trans; [|exact Hp].
apply (decr_of_derive p (fun _ => a1) t0 t Ht); intros s Hs; [apply (H s); lra|lra].
Qed.

Lemma cone_derive t : t0 <= t -> y t < z t ->
  is_derive d0 t (d1 t) /\ is_derive w t ((f t + w t) / eps) /\ is_derive f t (- a3 * h t) /\
    is_derive h t ((k t + 2 * d0 t) / eps) /\
  is_derive k t ((- 3 * k t + (- p t - 5) * (h t + d0 t) + (- p t - 6 + eps * (a3 - a1)) * d0 t - w t) / eps).
Proof.
intros Ht Hc.
destruct (excess_derive a1 a2 a3 eps Ha13 Heps p b y v z t (in_contact a1 a2 a3 eps p b y v z t (H t Ht) Hc))
  as (Dw & D0 & D1 & D2).
fold (w t) (d0 t) (d1 t) (d2 t) in *.
assert (L : forall (f1 f2 : R -> R) c1 c2 l1 l2, is_derive f1 t l1 -> is_derive f2 t l2 ->
  is_derive (fun t => c1 * f1 t - c2 * f2 t) t (c1 * l1 - c2 * l2)).
{ intros f1 f2 c1 c2 l1 l2 E1 E2. apply (is_derive_minus (fun t => c1 * f1 t) (fun t => c2 * f2 t)).
  apply (is_derive_scal f1), E1. apply (is_derive_scal f2), E2. }
refine (conj D0 (conj _ (conj _ (conj _ _)))).
- apply (is_derive_val _ _ _ _ Dw). unfold f. field. lra.
- apply (is_derive_ext (fun t => (- a3 * eps) * d0 t - 1 * w t)).
  { intros x. match goal with |- ?l = ?r => change (@eq R l r) end. unfold f. ring. }
  apply (is_derive_val _ _ _ _ (L d0 w _ _ _ _ D0 Dw)). unfold h. ring.
- apply (is_derive_ext (fun t => eps * d1 t - 1 * d0 t)).
  { intros x. match goal with |- ?l = ?r => change (@eq R l r) end. unfold h. ring. }
  apply (is_derive_val _ _ _ _ (L d1 d0 _ _ _ _ D1 D0)). unfold k. field. lra.
- apply (is_derive_ext (fun t => eps ^ 2 * d2 t - 1 * (eps * d1 t - (- 2) * d0 t))).
  { intros x. match goal with |- ?l = ?r => change (@eq R l r) end. unfold k. ring. }
  apply (is_derive_val _ _ _ _ (L d2 (fun t => eps * d1 t - (- 2) * d0 t) _ _ _ _ D2 (L d1 d0 _ _ _ _ D1 D0))).
  unfold k, h. field. lra.
Qed.

Definition In_cone (t : R) : Prop := y t < z t /\ late_cone a1 a2 a3 eps (p t) (b t) (y t) (v t) (z t).

Lemma in_cone t : In_cone t <-> y t < z t /\ 0 < w t /\ 0 < f t /\ 0 < h t /\ 0 < k t.
Proof.
unfold In_cone, late_cone, f, h, k, w, d0, d1, d2, deviation, excess, excess1, excess2. cbv zeta.
split; intros (A & B & C & D & E); repeat split; lra.
Qed.

Lemma cone_signs t : 0 < w t -> 0 < f t -> 0 < d0 t.
Proof.
intros A B. unfold f in B. assert (C : 0 < - a3 * eps) by nra. apply (pos_of_prod_pos (- a3 * eps)); auto; lra.
Qed.

(** Plan: by induction along the time axis. The conditions are open, so they last a little longer. If they hold on [t0,
    t), then w, f, h, the excess d0 and k e^(3s/eps) increase there (G, from the derivatives of [cone_derive]): so they
    are still > 0 at t. *)
Theorem late_contact : In_cone t0 -> forall t, t0 <= t -> In_cone t.
Proof.
intros HP0. apply real_induction; auto.
- intros t Ht HP. assert (HPt := HP t ltac:(lra)). apply in_cone in HPt. destruct HPt as (P & P0 & P1 & P2 & P3).
  destruct (cone_ex t Ht) as (X0 & X1 & X2 & X3). destruct (late_state_ex t Ht) as (_ & _ & Xy & _ & Xz).
  assert (L : locally t (fun s => 0 < z s - y s)).
  { apply (continuous_pos (fun s => z s - y s)); [|lra]. auto_derive; auto. }
  assert (LL := filter_and _ _ L (filter_and _ _ (continuous_pos _ t X0 P0) (filter_and _ _ (continuous_pos _ t X1 P1)
    (filter_and _ _ (continuous_pos _ t X2 P2) (continuous_pos _ t X3 P3))))).
  destruct LL as [d Hd]. exists d. split. apply cond_pos.
  intros s Hs. destruct (Hd s) as (Q & Q0 & Q1 & Q2 & Q3).
  { unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_pos_eq; lra. }
  apply in_cone. repeat split; auto; lra.
- intros t Ht HP. apply in_cone in HP0. destruct HP0 as (A & A0 & A1 & A2 & A3).
  destruct (cone_ex t (Rlt_le _ _ Ht)) as (X0 & X1 & X2 & X3).
  assert (G : forall (g g' : R -> R), ex_derive g t -> (forall s, t0 <= s < t -> is_derive g s (g' s) /\ 0 <= g' s) ->
    g t0 <= g t).
  { intros g g' Xg Hg. apply (closed_ge g t0 t (g t0) Ht Xg). intros s Hs.
    apply Ropp_le_cancel. apply (decr_of_derive (fun x => - g x) (fun x => - g' x) t0 s (proj1 Hs)).
    - intros x Hx. apply (is_derive_opp g), Hg. lra.
    - intros x Hx. destruct (Hg x ltac:(lra)). lra. }
  assert (Hie : 0 < / eps) by (apply Rinv_0_lt_compat, Heps).
  assert (HQ : forall s, t0 <= s < t -> y s < z s /\ 0 < w s /\ 0 < f s /\ 0 < h s /\ 0 < k s /\ 0 < d0 s).
  { intros s Hs. destruct (proj1 (in_cone s) (HP s Hs)) as (P & P0 & P1 & P2 & P3).
    repeat split; auto. apply cone_signs; auto. }
  assert (G0 : w t0 <= w t).
  { apply (G w (fun s => (f s + w s) / eps) X0). intros s Hs. destruct (HQ s Hs) as (P & P0 & P1 & P2 & P3 & P4).
    destruct (cone_derive s ltac:(lra) P) as (_ & D & _). split; [exact D|apply Rmult_le_pos; lra]. }
  assert (G1 : f t0 <= f t).
  { apply (G f (fun s => - a3 * h s) X1). intros s Hs. destruct (HQ s Hs) as (P & P0 & P1 & P2 & P3 & P4).
    destruct (cone_derive s ltac:(lra) P) as (_ & _ & D & _). split; [exact D|nra]. }
  assert (G2 : h t0 <= h t).
  { apply (G h (fun s => (k s + 2 * d0 s) / eps) X2). intros s Hs. destruct (HQ s Hs) as (P & P0 & P1 & P2 & P3 & P4).
    destruct (cone_derive s ltac:(lra) P) as (_ & _ & _ & D & _). split; [exact D|apply Rmult_le_pos; lra]. }
  assert (G3 : k t0 * exp (3 * t0 / eps) <= k t * exp (3 * t / eps)).
  { apply (G (fun s => k s * exp (3 * s / eps)) (fun s =>
      ((- p s - 5) * (h s + d0 s) + (- p s - 6 + eps * (a3 - a1)) * d0 s - w s)
       / eps * exp (3 * s / eps))).
    - auto_derive; auto.
    - intros s Hs. destruct (HQ s Hs) as (P & P0 & P1 & P2 & P3 & P4).
      destruct (cone_derive s ltac:(lra) P) as (_ & _ & _ & _ & D). split.
      + eapply is_derive_val.
        * apply (is_derive_mult_R k (fun s => exp (3 * s / eps)) s _ (3 / eps * exp (3 * s / eps)) D).
          auto_derive; auto. unfold Rdiv; ring.
        * field. lra.
      + assert (Hps := late_p s (proj1 Hs)).
        assert (Hae : 0 < - a3 * eps) by nra. assert (Ha1e : 0 < - a1 * eps) by nra.
        assert (0 <= (- p s - 5) * (h s + d0 s)) by (apply Rmult_le_pos; lra).
        assert (Hw : w s <= - a3 * eps * d0 s) by (unfold f in P1; lra).
        assert (- a3 * eps * d0 s <= (- p s - 6 + eps * (a3 - a1)) * d0 s) by (apply Rmult_le_compat_r; lra).
        apply Rmult_le_pos; [|apply Rlt_le, exp_pos]. apply Rmult_le_pos; lra. }
  assert (K3 : 0 < k t).
  { assert (E1 := exp_pos (3 * t0 / eps)). assert (E2 := exp_pos (3 * t / eps)).
    assert (0 < k t0 * exp (3 * t0 / eps)) by (apply Rmult_lt_0_compat; auto).
    apply Rmult_lt_reg_r with (exp (3 * t / eps)); auto. lra. }
  apply in_cone. refine (conj _ (conj _ (conj _ (conj _ K3)))); try lra.
  assert (G4 : d0 t0 <= d0 t).
  { apply (G d0 (fun s => d1 s)).
    - destruct (late_state_ex t (Rlt_le _ _ Ht)) as (_ & _ & Xy & _ & Xz). unfold d0, excess, force_excess. auto_derive.
      auto.
    - intros s Hs. destruct (HQ s Hs) as (P & P0 & P1 & P2 & P3 & P4).
      destruct (cone_derive s ltac:(lra) P) as (D & _). split; [exact D|].
      unfold h in P2. apply Rlt_le, (pos_of_prod_pos eps); auto. lra. }
  unfold d0, excess, force_excess in G4. assert (He : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, Heps).
  unfold Rdiv in G4. nra.
Qed.

Lemma force_contact t : y t < z t -> contact_force eps (y t) (z t) = d0 t + a2 / (a3 - a1).
Proof. intros Hc. unfold contact_force, d0, excess, force_excess. destruct (Rlt_dec (y t) (z t)); [ring|lra]. Qed.

(** In the cone the force increases, at least in proportion to the time. *)
Theorem late_force : In_cone t0 ->
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)).
Proof.
intros HP. assert (Hall := late_contact HP).
assert (D : forall s, t0 <= s -> is_derive d0 s (d1 s) /\ d0 s < eps * d1 s /\ 0 < d0 s /\ y s < z s).
{ intros s Hs. assert (A := Hall s Hs). apply in_cone in A. destruct A as (P & P0 & P1 & P2 & P3).
  refine (conj (proj1 (cone_derive s Hs P)) (conj _ (conj (cone_signs s P0 P1) P))). unfold h in P2. lra. }
assert (Inc : forall s t, t0 <= s -> s < t -> d0 s < d0 t).
{ intros s t Hs Hst. destruct (mvt_open d0 d1 s t Hst) as (c & Hc & Em). intros x Hx. apply D. lra.
  destruct (D c ltac:(lra)) as (_ & A & A' & _).
  assert (0 < d1 c) by (apply (pos_of_prod_pos eps); auto; lra).
  assert (0 < d1 c * (t - s)) by (apply Rmult_lt_0_compat; lra). lra. }
split.
- intros s t Hs Hst. rewrite !force_contact by (apply D; lra). generalize (Inc s t Hs Hst). lra.
- intros M. set (m := M - a2 / (a3 - a1)). destruct (D t0 (Rle_refl _)) as (_ & _ & P0 & _).
  set (q := d0 t0 / eps). assert (Hq : 0 < q) by (apply Rdiv_lt_0_compat; auto).
  exists (t0 + Rabs m / q + 1). intros t Ht.
  assert (Hm : 0 <= Rabs m / q) by (apply Rmult_le_pos; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat, Hq]).
  rewrite force_contact by (apply D; lra).
  destruct (mvt_open d0 d1 t0 t ltac:(lra)) as (c & Hc & Em). intros x Hx. apply D. lra.
  destruct (D c ltac:(lra)) as (_ & A & _). assert (A' := Inc t0 c ltac:(lra) ltac:(lra)).
  assert (Hd : q <= d1 c).
  { apply Rmult_le_reg_l with eps; auto. unfold q. replace (eps * (d0 t0 / eps)) with (d0 t0) by (field; lra). lra. }
  assert (B : q * (Rabs m / q) <= d1 c * (t - t0)) by (apply Rmult_le_compat; lra).
  replace (q * (Rabs m / q)) with (Rabs m) in B by (field; lra).
  assert (B' := Rle_abs m). unfold m in *. lra.
Qed.

End Cone.

(** The slow motions on the side of impact without collision come into the cone. *)
Theorem slow_in_late_cone (a1 a2 a3 eps C : R) : a1 < 0 -> a3 < 0 -> 0 < eps -> not_nat (a3 / a1) ->
  0 < C * Gamma (- (a3 / a1)) ->
  exists T, 0 <= T /\ forall t, T <= t -> late_cone a1 a2 a3 eps (sol_p a1 t) (sol_b a1 a2 a3 eps C t)
    (sol_y a1 a2 a3 eps C t)
    (sol_v a1 a3 eps C t) (sol_z a1 a2 a3 eps C t).
Proof.
intros Ha1 Ha3 He Hb HC. assert (Ha13 := a13 a1 a3 Ha1 Hb).
assert (Hg := not_nat_Gamma (a3 / a1) Hb). assert (He' := He' a1 eps Ha1 He).
destruct (Fe_right _ He' (a3 / a1) 0 Hb 1) as (T0 & HT0 & F0).
destruct (Fe_ratio _ He' (a3 / a1) 0 1 Hb ltac:(lra)) as (T1 & HT1 & F1).
destruct (Fe_ratio _ He' (a3 / a1) 1 1 Hb ltac:(lra)) as (T2 & HT2 & F2).
destruct (Fe_ratio _ He' (a3 / a1) 2 3 Hb ltac:(lra)) as (T3 & HT3 & F3).
assert (N : 0 <= eps * (T0 + T1 + T2 + T3)) by (apply Rmult_le_pos; lra).
exists (eps * (T0 + T1 + T2 + T3)). split; auto. intros t Ht.
set (g := fun n => Gamma (- (a3 / a1)) * Derive_n (Fe (- a1 * eps) (a3 / a1)) n (t / eps)).
assert (HT : T0 + T1 + T2 + T3 <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). exact Ht. }
assert (G0 : 1 <= g 0%nat) by (apply F0; lra). assert (G1 : 1 * g 0%nat < g 1%nat) by (apply F1; lra).
assert (G2 : 1 * g 1%nat < g 2%nat) by (apply F2; lra). assert (G3 : 3 * g 2%nat < g 3%nat) by (apply F3; lra).
set (q := C / Gamma (- (a3 / a1))).
assert (Hq : 0 < q).
{ unfold q. replace (C / Gamma (- (a3 / a1))) with (C * Gamma (- (a3 / a1)) * (/ Gamma (- (a3 / a1))) ^ 2)
    by (field; auto).
  apply Rmult_lt_0_compat; auto. apply pow2_gt_0, Rinv_neq_0_compat, Hg. }
assert (Eh : forall n, eps ^ n * hb a1 a3 eps C n t = q * g n).
{ intros n. unfold hb, q, g. field. split; auto. apply pow_nonzero; lra. }
assert (E0 := Eh 0%nat). assert (E1 := Eh 1%nat). assert (E2 := Eh 2%nat). assert (E3 := Eh 3%nat).
assert (P0 : 0 < q * g 0%nat) by (apply Rmult_lt_0_compat; lra).
assert (P1 : 0 < q * (g 1%nat - g 0%nat)) by (apply Rmult_lt_0_compat; lra).
assert (P2 : 0 < q * (g 2%nat - g 1%nat)) by (apply Rmult_lt_0_compat; lra).
assert (P3 : 0 < q * (g 3%nat - g 2%nat - 2 * g 1%nat)) by (apply Rmult_lt_0_compat; lra).
assert (Hi : 0 < / (- a3 * eps)) by (apply Rinv_0_lt_compat; nra).
unfold late_cone. cbv zeta. unfold sol_p, sol_b, sol_y, sol_v, sol_z, rec_p.
assert (D0 : force_excess a1 a2 a3 eps (rec_y a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2)
  (hb a1 a3 eps C 3) t)
  (rec_z a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
    = / (- a3 * eps) * (q * g 1%nat)).
{ rewrite <- E1. unfold force_excess, rec_y, rec_z. field. repeat split; lra. }
assert (D1 : eps * force_excess1 eps (rec_y a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2)
  (hb a1 a3 eps C 3) t)
  (rec_v a1 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
  (rec_z a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
    = / (- a3 * eps) * (q * g 2%nat)).
{ rewrite <- E2. unfold force_excess1, rec_y, rec_v, rec_z. field. repeat split; lra. }
assert (D2 : eps ^ 2 * force_excess2 eps (a1 * t) (rec_b a1 a2 a3 (hb a1 a3 eps C 0) t)
  (rec_y a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
  (rec_v a1 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
  (rec_z a1 a2 a3 eps (hb a1 a3 eps C 0) (hb a1 a3 eps C 1) (hb a1 a3 eps C 2) (hb a1 a3 eps C 3) t)
    = / (- a3 * eps) * (q * g 3%nat)).
{ rewrite <- E3. unfold force_excess2, rec_b, rec_y, rec_v, rec_z. field. repeat split; lra. }
rewrite D0, D1, D2. simpl pow in E0. rewrite Rmult_1_l in E0.
refine (conj _ (conj _ (conj _ _))).
- unfold rec_b. rewrite E0. lra.
- unfold rec_b. rewrite E0. replace (- a3 * eps * (/ (- a3 * eps) * (q * g 1%nat))) with (q * g 1%nat) by (field; lra).
  lra.
- nra.
- nra.
Qed.
