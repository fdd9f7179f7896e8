(** * The compliant model: an explicit bound for eps

    0 < beta < 5. By [CompliantMonotone.v] with n = 1 the contact force of a slow motion is above the force at leading
    order, at every time and every eps, on the side C_1 Gamma(-beta) > 0, and below it on the other. So for 1 < beta and
    C_1 Gamma(-beta) > 0 a lower bound -m of C_1 dTheta/dtau gives an eps_0 up to which contact is never lost; such a
    bound exists on every half-line [tau_0, oo), since C_1 dTheta/dtau tends to +oo, and for C_1 < 0 on R. A motion of
    the mechanism that starts on a slow motion with a positive force stays on it (uniqueness forwards in time). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral WellPosed Family Ends
  CompliantKernel CompliantIntegral
  CompliantSlow CompliantMechanism CompliantDependence CompliantForward CompliantSlowMotion CompliantMonotone.
Open Scope R_scope.

(** The scale: 2 eta^3 = - a1 eps, eta/eps = kappa eps^(-2/3). *)
Section Scale.
Variables (a1 eps : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Heps : 0 < eps.

Let kappa := Rpower (- a1 / 2) (1 / 3).
Definition eta_of : R := Rpower (- a1 / 2) (1 / 3) * Rpower eps (1 / 3).

Lemma eta_of_pos : 0 < eta_of.
Proof. apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma Rpower_third x : 0 < x -> Rpower x (1 / 3) ^ 3 = x.
Proof.
intros Hx. rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult.
replace (1 / 3 * INR 3) with 1 by (simpl; field). apply Rpower_1, Hx.
Qed.

Lemma eta_of_cube : 2 * eta_of ^ 3 = - a1 * eps.
Proof. unfold eta_of. rewrite Rpow_mult_distr, !Rpower_third by lra. field. Qed.

Lemma eta_of_time t : eta_of * (t / eps) = kappa * t * Rpower eps (- 2 / 3).
Proof.
unfold eta_of. fold kappa.
replace (- 2 / 3) with (1 / 3 + - (1)) by field. rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by auto. field. lra.
Qed.

Lemma eta_of_factor C1 a3 beta : a3 <> 0 ->
  C1 * Rpower eps beta / (- a3 * eps) * Rpower eta_of (1 - beta)
    = - (C1 / a3 * Rpower kappa (1 - beta) * Rpower eps ((2 * beta - 2) / 3)) .
Proof.
intros H3. unfold eta_of. fold kappa. rewrite <- Rpower_mult_distr by apply exp_pos. rewrite Rpower_mult.
assert (E : Rpower eps ((2 * beta - 2) / 3) = Rpower eps beta * Rpower eps (1 / 3 * (1 - beta)) * / eps).
{ rewrite <- (Rpower_1 eps) at 4 by auto. rewrite <- Rpower_Ropp, <- !Rpower_plus. f_equal. field. }
rewrite E. field. split; lra.
Qed.
End Scale.

(** ** The force at leading order, every beta *)

Lemma leading_force_factor a1 a2 a3 eps C1 theta t : a3 < 0 -> exists q, 0 < q /\
  q = / (- a3) * (Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - a3 / a1) * Rpower eps ((2 * (a3 / a1) - 2) / 3)) /\
  leading_force a1 a2 a3 eps C1 theta t
    = a2 / (a3 - a1) + q * (C1 * Derive theta (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3))).
Proof.
intros H3. eexists. refine (conj _ (conj eq_refl _)).
- apply Rmult_lt_0_compat. apply Rinv_0_lt_compat; lra. apply Rmult_lt_0_compat; apply exp_pos.
- unfold leading_force. unfold Rdiv at 2. replace (/ a3) with (- / (- a3)) by (field; lra). ring.
Qed.

(** Below the threshold that factor times m is less than the mean force. *)
Lemma threshold_factor a1 a2 a3 eps m : a1 < 0 -> a3 < 0 -> 0 < eps -> 1 < a3 / a1 -> a2 < 0 -> 0 < m ->
  let q := / (- a3) * (Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - a3 / a1) * Rpower eps ((2 * (a3 / a1) - 2) / 3)) in
  (eps <= threshold a1 a2 a3 m -> q * m <= a2 / (a3 - a1)) /\ (eps < threshold a1 a2 a3 m -> q * m < a2 / (a3 - a1)).
Proof.
intros H1 H3 He Hb H2 Hm q. unfold threshold.
set (beta := a3 / a1) in *. set (kappa := Rpower (- a1 / 2) (1 / 3)) in *.
assert (Ea : a3 = beta * a1) by (unfold beta; field; lra).
assert (H31 : a3 - a1 < 0) by nra.
set (mean := a2 / (a3 - a1)) in *.
assert (Hmean : 0 < mean).
{ unfold mean. replace (a2 / (a3 - a1)) with ((- a2) / (- (a3 - a1))) by (field; lra). apply Rdiv_lt_0_compat; lra. }
set (K := Rpower kappa (beta - 1)). assert (HK : 0 < K) by apply exp_pos.
set (A := - a3 * mean * K / m).
assert (HA : 0 < A).
{ unfold A. apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; lra. }
assert (EA : Rpower (Rpower A (3 / (2 * beta - 2))) ((2 * beta - 2) / 3) = A).
{ rewrite Rpower_mult. replace (3 / (2 * beta - 2) * ((2 * beta - 2) / 3)) with 1 by (field; lra). apply Rpower_1, HA. }
assert (Em : mean = / (- a3) * (/ K * A) * m) by (unfold A; field; repeat split; lra).
assert (Hq : 0 < / (- a3) * / K * m).
{ apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra. }
unfold q. replace (1 - beta) with (- (beta - 1)) by ring. rewrite Rpower_Ropp. fold K.
set (E := Rpower eps ((2 * beta - 2) / 3)).
assert (Hp : 0 < (2 * beta - 2) / 3) by (apply Rdiv_lt_0_compat; lra).
rewrite Em. replace (/ (- a3) * (/ K * E) * m) with (/ (- a3) * / K * m * E) by ring.
replace (/ (- a3) * (/ K * A) * m) with (/ (- a3) * / K * m * A) by ring.
split; intros H.
- apply Rmult_le_compat_l; [lra|]. rewrite <- EA. apply Rle_Rpower_l; [lra|split; auto].
- apply Rmult_lt_compat_l; [lra|]. rewrite <- EA. apply exp_increasing, Rmult_lt_compat_l; auto.
  apply ln_increasing; auto.
Qed.

Section Force.
Variables (a1 a2 a3 eps C1 : R) (theta P B Y V Z : R -> R).
Hypothesis Hpar : parameters a1 a3 eps.
Hypothesis HT : is_Theta (a3 / a1) theta.
Hypothesis HS : slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) P B Y V Z.
Let H1 : a1 < 0 := proj1 Hpar.
Let H3 : a3 < 0 := proj1 (proj2 Hpar).
Let He : 0 < eps := proj1 (proj2 (proj2 Hpar)).
Let Hb : not_nat (a3 / a1) := proj2 (proj2 (proj2 Hpar)).
Let G := Gamma (- (a3 / a1)).

(** The difference of the two forces has the sign of C_1 Gamma(-beta). *)
Lemma force_difference t : a3 / a1 < 5 -> exists q, 0 < q /\
  linear_force eps (Y t) (Z t) - leading_force a1 a2 a3 eps C1 theta t = C1 * G * q.
Proof.
intros H5.
rewrite (slow_force a1 a2 a3 eps Hpar _ P B Y V Z HS t). unfold sol_l, leading_force.
rewrite <- (eta_of_time a1 eps He t). set (tau := eta_of a1 eps * (t / eps)).
assert (Hn := eta_of_pos a1 eps). set (eta := eta_of a1 eps) in *.
assert (Et : t / eps = tau / eta) by (unfold tau; field; split; lra).
assert (M := above_leading_order (a3 / a1) 1 eta theta tau Hb ltac:(simpl; lra) Hn HT).
rewrite <- (scaled_slow (a3 / a1) 1 eta tau Hn Hb) in M. destruct M as [M _].
unfold eta in M at 2. rewrite (eta_of_cube a1 eps H1 He) in M. rewrite <- Et in M.
unfold scaled in M. change (Derive_n theta 1 tau) with (Derive theta tau) in M.
change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in M.
set (F := Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)) in *. set (D := Derive theta tau) in *.
assert (E := eta_of_factor a1 eps He C1 a3 (a3 / a1) ltac:(lra)). fold eta in E.
replace (a2 / (a3 - a1) + C1 * Rpower eps (a3 / a1) / (- a3 * eps) * F -
   (a2 / (a3 - a1) - C1 / a3 * Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - a3 / a1) * Rpower eps ((2 * (a3 / a1) - 2) / 3)
     * D))
  with (C1 * Rpower eps (a3 / a1) / (- a3 * eps) * F -
   - (C1 / a3 * Rpower (Rpower (- a1 / 2) (1 / 3)) (1 - a3 / a1) * Rpower eps ((2 * (a3 / a1) - 2) / 3)) * D) by ring.
rewrite <- E.
assert (Hg : G <> 0) by (apply not_nat_Gamma, Hb). fold G in M.
set (R1 := Rpower eta (1 - a3 / a1)). assert (HR : 0 < R1) by apply exp_pos.
replace (a3 / a1 - INR 1) with (- (1 - a3 / a1)) in M by (simpl; ring). rewrite Rpower_Ropp in M. fold R1 in M.
exists (Rpower eps (a3 / a1) / (- a3 * eps) * R1 * (G * (/ R1 * F) - G * D) * (/ G) ^ 2). split.
- assert (0 < / (- a3 * eps)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
  apply Rmult_lt_0_compat; [|apply pow2_gt_0, Rinv_neq_0_compat, Hg].
  apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply exp_pos.
- field. repeat split; auto; lra.
Qed.

Theorem force_above_leading_order t : a3 / a1 < 5 ->
  (0 < C1 * G -> leading_force a1 a2 a3 eps C1 theta t < linear_force eps (Y t) (Z t)) /\
  (C1 * G < 0 -> linear_force eps (Y t) (Z t) < leading_force a1 a2 a3 eps C1 theta t).
Proof.
intros H5. destruct (force_difference t H5) as (q & Hq & E). split; intros HC.
- assert (0 < C1 * G * q) by (apply Rmult_lt_0_compat; auto). lra.
- assert (0 < - (C1 * G) * q) by (apply Rmult_lt_0_compat; auto; lra). lra.
Qed.

(** *** A motion of the mechanism from a state of a slow motion whose force is positive from t0 on *)
Section Kept.
Variable t0 : R.
Hypothesis HC : 0 < C1 * G.
Hypothesis force_positive : forall t, t0 <= t -> 0 < linear_force eps (Y t) (Z t).

Theorem contact_kept p b y v z :
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros H Ip Ib Iy Iv Iz.
destruct HS as (_ & Hm0 & _).
assert (Hmod : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force P B Y V Z t).
{ intros t Ht. assert (E : contact_force eps (Y t) (Z t) = linear_force eps (Y t) (Z t)).
  { apply contact_force_in_contact; auto. apply Rlt_le, force_positive, Ht. }
  specialize (Hm0 t). unfold model_at in *. rewrite E. exact Hm0. }
assert (E : forall t, t0 <= t -> y t = Y t /\ z t = Z t).
{ intros t Ht.
  destruct (forward_unique a1 a2 a3 eps He p b y v z P B Y V Z t0 t (fun s Hs => H s (proj1 Hs)) (fun s Hs =>
    Hmod s (proj1 Hs))
    Ip Ib Iy Iv Iz t ltac:(lra)) as (_ & _ & E1 & _ & E2). auto. }
assert (Hcon : forall t, t0 <= t -> y t < z t).
{ intros t Ht. destruct (E t Ht) as (-> & ->). apply (linear_force_pos eps); [|apply force_positive, Ht]; exact He. }
assert (Hinf : forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)).
{ assert (HC' : 0 < C1 * Rpower eps (a3 / a1) * G).
  { replace (C1 * Rpower eps (a3 / a1) * G) with (Rpower eps (a3 / a1) * (C1 * G)) by ring.
    apply Rmult_lt_0_compat; auto. apply exp_pos. }
  intros M. destruct (proj1 (side_rule a1 a2 a3 eps Hpar _ P B Y V Z HS) HC' M) as (T & HT').
  exists (Rmax T t0). intros t Ht. assert (M1 := Rmax_l T t0). assert (M2 := Rmax_r T t0).
  destruct (E t ltac:(lra)) as (-> & ->). rewrite contact_force_in_contact; auto.
  - apply HT'. lra.
  - apply Rlt_le, force_positive. lra. }
refine (conj Hcon (conj Hinf _)).
apply (penetrate eps t0 y z (fun t => contact_force eps (y t) (z t)) He); auto.
- intros t Ht. apply (H t Ht).
- intros t Ht. apply Hcon. lra.
Qed.
End Kept.

(** *** The bound for eps *)
Lemma leading_force_nonnegative m t : 1 < a3 / a1 -> a2 < 0 -> 0 < m -> eps <= threshold a1 a2 a3 m ->
  - m <= C1 * Derive theta (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) ->
  0 <= leading_force a1 a2 a3 eps C1 theta t.
Proof.
intros Hb1 H2 Hm Heps HD. destruct (leading_force_factor a1 a2 a3 eps C1 theta t H3) as (q & Hq & Eq & ->).
assert (U := proj1 (threshold_factor a1 a2 a3 eps m H1 H3 He Hb1 H2 Hm) Heps). cbv zeta in U. rewrite <- Eq in U.
assert (L := Rmult_le_compat_l q _ _ (Rlt_le _ _ Hq) HD). lra.
Qed.

Section Threshold.
Variables (m tau0 t0 : R).
Hypothesis Hbeta : 1 < a3 / a1 < 5.
Hypothesis H2 : a2 < 0.
Hypothesis HC : 0 < C1 * G.
Hypothesis Hm : 0 < m.
Hypothesis Hleast : forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau.
Hypothesis Hsmall : eps <= threshold a1 a2 a3 m.
Hypothesis Hstart : tau0 <= Rpower (- a1 / 2) (1 / 3) * t0 * Rpower eps (- 2 / 3).

Lemma force_positive t : t0 <= t -> 0 < linear_force eps (Y t) (Z t).
Proof.
intros Ht. eapply Rle_lt_trans; [|apply (proj1 (force_above_leading_order t ltac:(lra)) HC)].
apply (leading_force_nonnegative m); auto; try lra. apply Hleast. eapply Rle_trans; [exact Hstart|].
apply Rmult_le_compat_r. apply Rlt_le, exp_pos. apply Rmult_le_compat_l; auto. apply Rlt_le, exp_pos.
Qed.

Theorem IWC_below_threshold p b y v z :
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof. apply (contact_kept t0 HC force_positive). Qed.
End Threshold.
End Force.

(** ** The lower bound exists *)

Lemma bounded_below_on (f : R -> R) x y : (forall t, ex_derive f t) -> exists m, 0 < m /\ forall t, x <= t <= y ->
  - m <= f t.
Proof.
intros D. destruct (Rle_lt_dec x y) as [H|H].
- destruct (continuity_ab_min f x y H) as (c & Hc & _).
  { intros t _. apply continuity_pt_filterlim, (ex_derive_continuous f), D. }
  exists (Rabs (f c) + 1). split. generalize (Rabs_pos (f c)); lra.
  intros t Ht. specialize (Hc t Ht). assert (A := Rle_abs (- f c)). rewrite Rabs_Ropp in A. lra.
- exists 1. split; [lra|]. intros t Ht. lra.
Qed.

Theorem least_value_exists b theta C1 : 0 < b -> not_nat b -> is_Theta b theta -> 0 < C1 * Gamma (- b) ->
  (forall tau0, exists m, 0 < m /\ forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) /\
  (C1 < 0 -> exists m, 0 < m /\ forall tau, - m <= C1 * Derive theta tau).
Proof.
intros Hb Hn HT HC.
assert (Hg := not_nat_Gamma b Hn).
assert (D : forall t, ex_derive (fun t => C1 * Derive theta t) t).
{ intros t. destruct (is_Theta_elim b theta HT) as (_ & D1 & _).
  exists (C1 * Derive_n theta 2 t). apply (is_derive_scal (Derive theta)), D1. }
destruct (scaled_right b theta Hn HT 1 0) as (T & HR).
assert (HR' : forall t, T <= t -> 0 <= C1 * Derive theta t).
{ intros t Ht. specialize (HR t Ht). unfold scaled in HR. change (Derive_n theta 1 t) with (Derive theta t) in HR.
  replace (C1 * Derive theta t) with (C1 * Gamma (- b) * (Gamma (- b) * Derive theta t) * (/ Gamma (- b)) ^ 2)
    by (field; auto).
  apply Rmult_le_pos; [|apply pow2_ge_0]. apply Rmult_le_pos; lra. }
split.
- intros tau0. destruct (bounded_below_on _ tau0 T D) as (m & Hm & H). exists m. split; auto.
  intros t Ht. destruct (Rle_lt_dec t T) as [Hl|Hl]. apply H; lra. specialize (HR' t ltac:(lra)). lra.
- intros HC1. destruct (Ends.left_end b theta Hb Hn HT) as (T' & HL).
  destruct (bounded_below_on _ T' T D) as (m & Hm & H). exists m. split; auto.
  intros t. destruct (Rle_lt_dec t T') as [Hl|Hl].
  + specialize (HL t Hl). assert (0 < - C1 * - Derive theta t) by (apply Rmult_lt_0_compat; lra). lra.
  + destruct (Rle_lt_dec t T) as [Hl'|Hl']. apply H; lra. specialize (HR' t ltac:(lra)). lra.
Qed.

(** ** The force at leading order below the threshold, and its side *)

Theorem leading_force_positive a1 a2 a3 eps C1 theta m tau0 t : a1 < 0 -> a3 < 0 -> 0 < eps -> 1 < a3 / a1 -> a2 < 0 ->
  0 < m -> (forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) -> eps < threshold a1 a2 a3 m ->
  tau0 <= Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) -> 0 < leading_force a1 a2 a3 eps C1 theta t.
Proof.
intros H1 H3 He Hb H2 Hm Hl Hs Ht. destruct (leading_force_factor a1 a2 a3 eps C1 theta t H3) as (q & Hq & Eq & ->).
assert (U := proj2 (threshold_factor a1 a2 a3 eps m H1 H3 He Hb H2 Hm) Hs). cbv zeta in U. rewrite <- Eq in U.
assert (L := Rmult_le_compat_l q _ _ (Rlt_le _ _ Hq) (Hl _ Ht)). lra.
Qed.

Theorem leading_side_rule a1 a2 a3 eps C1 theta : parameters a1 a3 eps -> is_Theta (a3 / a1) theta ->
  (0 < C1 * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t ->
    M <= leading_force a1 a2 a3 eps C1 theta t) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> leading_force a1 a2 a3 eps C1 theta t <= M).
Proof.
intros (H1 & H3 & He & Hb) HT. set (b := a3 / a1) in *.
assert (Hg := not_nat_Gamma b Hb). set (G := Gamma (- b)) in *.
set (k := Rpower (- a1 / 2) (1 / 3)). assert (Hk : 0 < k) by apply exp_pos.
set (e := Rpower eps (- 2 / 3)). assert (He' : 0 < e) by apply exp_pos.
assert (Up : forall C, 0 < C * G -> forall M, exists T, forall t, T <= t -> M <= C * Derive theta (k * t * e)).
{ intros C HC M. destruct (scaled_right b theta Hb HT 1 (G ^ 2 * M / (C * G))) as (T & H).
  exists (T / (k * e)). intros t Ht.
  assert (Hke : 0 < k * e) by (apply Rmult_lt_0_compat; auto).
  assert (A : T <= k * t * e).
  { apply (Rmult_le_compat_r (k * e)) in Ht; [|lra].
    replace (T / (k * e) * (k * e)) with T in Ht by (field; split; lra). lra. }
  specialize (H _ A). unfold scaled in H. change (Derive_n theta 1 (k * t * e)) with (Derive theta (k * t * e)) in H.
  fold G in H.
  set (D := Derive theta (k * t * e)) in *.
  apply (Rmult_le_compat_l (C * G)) in H; [|lra].
  replace (C * G * (G ^ 2 * M / (C * G))) with (G ^ 2 * M) in H by (field; split; auto; intros ->; lra).
  apply Rmult_le_reg_l with (G ^ 2). apply pow2_gt_0, Hg. replace (G ^ 2 * (C * D)) with (C * G * (G * D)) by ring.
  exact H. }
set (mean := a2 / (a3 - a1)).
split; intros HC M.
- destruct (leading_force_factor a1 a2 a3 eps C1 theta 0 H3) as (q & Hq & Eq & _).
  destruct (Up C1 HC ((M - mean) / q)) as (T & H). exists T. intros t Ht. specialize (H t Ht).
  destruct (leading_force_factor a1 a2 a3 eps C1 theta t H3) as (q' & _ & Eq' & ->). rewrite <- Eq in Eq'. subst q'.
  fold mean k e. apply (Rmult_le_compat_l q) in H; [|lra].
  replace (q * ((M - mean) / q)) with (M - mean) in H by (field; lra). lra.
- destruct (leading_force_factor a1 a2 a3 eps C1 theta 0 H3) as (q & Hq & Eq & _).
  destruct (Up (- C1) ltac:(lra) ((mean - M) / q)) as (T & H). exists T. intros t Ht. specialize (H t Ht).
  destruct (leading_force_factor a1 a2 a3 eps C1 theta t H3) as (q' & _ & Eq' & ->). rewrite <- Eq in Eq'. subst q'.
  fold mean k e. apply (Rmult_le_compat_l q) in H; [|lra].
  replace (q * ((mean - M) / q)) with (mean - M) in H by (field; lra). lra.
Qed.
