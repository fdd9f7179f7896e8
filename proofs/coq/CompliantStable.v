(** * The compliant model: impact without collision is stable

    A motion in contact from t0 on that comes into the cone of [CompliantLateCone], as a slow motion on the side C
    Gamma(-beta) > 0 does, is in it at some time T. Up to T motions that start near it stay near it ([motions_close]),
    so in contact; at T they are in the cone, which is open; after T they stay there. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction CompliantMechanism CompliantContact
  CompliantDependence CompliantForward CompliantSlowMotion
  CompliantLateCone.
Open Scope R_scope.

Lemma linear_bound k x r : Rabs x <= r -> Rabs (k * x) <= Rabs k * r.
Proof. intros H. rewrite Rabs_mult. apply Rmult_le_compat_l; auto using Rabs_pos. Qed.

(** The conditions of the cone are affine in the changes of the state, but for a product with that of p. *)
Lemma open_condition X k0 k1 k2 k3 k4 k5 : 0 < X -> exists r0, 0 < r0 /\ forall r p b y v z, 0 < r -> r <= r0 ->
  r <= 1 ->
  Rabs p <= r -> Rabs b <= r -> Rabs y <= r -> Rabs v <= r -> Rabs z <= r ->
  0 < X + (k0 * p + k1 * b + k2 * y + k3 * v + k4 * z + k5 * (p * (z - y))).
Proof.
intros HX.
set (K := Rabs k0 + Rabs k1 + Rabs k2 + Rabs k3 + Rabs k4 + 2 * Rabs k5 + 1).
assert (HK : 0 < K).
{ unfold K. generalize (Rabs_pos k0) (Rabs_pos k1) (Rabs_pos k2) (Rabs_pos k3) (Rabs_pos k4) (Rabs_pos k5). lra. }
exists (X / K). split. { apply Rdiv_lt_0_compat; auto. }
intros r p b y v z Hr0 Hr Hr1 Hp Hb Hy Hv Hz.
assert (EX : K * r <= X).
{ replace X with (K * (X / K)) by (field; lra). apply Rmult_le_compat_l; lra. }
assert (H5 : Rabs (p * (z - y)) <= 2 * r).
{ rewrite Rabs_mult. assert (Rabs (z - y) <= 2 * r).
  { unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  assert (Rabs p * Rabs (z - y) <= 1 * (2 * r)) by (apply Rmult_le_compat; try apply Rabs_pos; lra). lra. }
assert (A0 := linear_bound k0 _ _ Hp). assert (A1 := linear_bound k1 _ _ Hb). assert (A2 := linear_bound k2 _ _ Hy).
assert (A3 := linear_bound k3 _ _ Hv). assert (A4 := linear_bound k4 _ _ Hz). assert (A5 := linear_bound k5 _ _ H5).
apply Rabs_le_between in A0, A1, A2, A3, A4, A5. unfold K in EX. lra.
Qed.

(** The cone is open. *)
Lemma late_cone_open a1 a2 a3 eps P B Y V Z : a1 <> a3 -> 0 < eps -> late_cone a1 a2 a3 eps P B Y V Z ->
  exists r, 0 < r <= 1 /\ forall p b y v z, Rabs (p - P) <= r -> Rabs (b - B) <= r -> Rabs (y - Y) <= r ->
    Rabs (v - V) <= r ->
    Rabs (z - Z) <= r -> late_cone a1 a2 a3 eps p b y v z.
Proof.
intros Ha13 He (C0 & C1 & C2 & C3). unfold late_cone, force_excess, force_excess1, force_excess2 in *.
set (q := a2 / (a1 - a3)) in *.
destruct (open_condition (B - q * P) (- q) 1 0 0 0 0 ltac:(lra)) as (r0 & R0 & F0).
destruct (open_condition (- a3 * eps * ((Z - Y) / eps ^ 2 - a2 / (a3 - a1)) - (B - q * P))
  q (- 1) (a3 / eps) 0 (- a3 / eps) 0 ltac:(lra)) as (r1 & R1 & F1).
destruct (open_condition (eps * (((Y - 2 * Z) / eps - V) / eps ^ 2) - ((Z - Y) / eps ^ 2 - a2 / (a3 - a1)))
  0 0 (2 / eps ^ 2) (- / eps) (- 3 / eps ^ 2) 0 ltac:(lra)) as (r2 & R2 & F2).
destruct (open_condition (eps ^ 2 * (((V - 2 * ((Y - 2 * Z) / eps)) / eps - (B + P * ((Z - Y) / eps ^ 2))) / eps ^ 2)
    - (eps * (((Y - 2 * Z) / eps - V) / eps ^ 2) + 2 * ((Z - Y) / eps ^ 2 - a2 / (a3 - a1))))
  (- (Z - Y) / eps ^ 2) (- 1) (- 1 / eps ^ 2 + P / eps ^ 2) (2 / eps) (4 / eps ^ 2 - P / eps ^ 2) (- / eps ^ 2)
    ltac:(lra)) as (r3 & R3 & F3).
set (r := Rmin (Rmin (Rmin r0 r1) (Rmin r2 r3)) 1).
assert (M1 := Rmin_l (Rmin (Rmin r0 r1) (Rmin r2 r3)) 1). assert (M2 := Rmin_r (Rmin (Rmin r0 r1) (Rmin r2 r3)) 1).
assert (M3 := Rmin_l (Rmin r0 r1) (Rmin r2 r3)). assert (M4 := Rmin_r (Rmin r0 r1) (Rmin r2 r3)).
assert (M5 := Rmin_l r0 r1). assert (M6 := Rmin_r r0 r1). assert (M7 := Rmin_l r2 r3). assert (M8 := Rmin_r r2 r3).
fold r in M1, M2.
assert (Hr : 0 < r) by (unfold r; repeat apply Rmin_pos; lra).
exists r. split; [lra|]. intros p b y v z Dp Db Dy Dv Dz.
specialize (F0 r _ _ _ _ _ Hr ltac:(lra) M2 Dp Db Dy Dv Dz).
specialize (F1 r _ _ _ _ _ Hr ltac:(lra) M2 Dp Db Dy Dv Dz).
specialize (F2 r _ _ _ _ _ Hr ltac:(lra) M2 Dp Db Dy Dv Dz).
specialize (F3 r _ _ _ _ _ Hr ltac:(lra) M2 Dp Db Dy Dv Dz).
clearbody q.
refine (conj _ (conj _ (conj _ _))); apply Rminus_gt_0_lt.
- eapply Rlt_le_trans; [exact F0|right]. ring.
- eapply Rlt_le_trans; [exact F1|right]. field. split; lra.
- eapply Rlt_le_trans; [exact F2|right]. field. split; lra.
- eapply Rlt_le_trans; [exact F3|right]. field. split; lra.
Qed.

(** After the cone is reached. *)
Theorem late_IWC : StatementCompliant.IWC_late.
Proof.
intros a1 a2 a3 eps t0 p b y v z Ha1 Ha3 Ha13 He H Hp Hc Hin.
assert (HI : In_cone a1 a2 a3 eps p b y v z t0) by (split; auto).
assert (Late := late_contact a1 a2 a3 eps Ha1 Ha3 Ha13 He p b y v z t0 Hp H HI).
destruct (late_force a1 a2 a3 eps Ha1 Ha3 Ha13 He p b y v z t0 Hp H HI) as (Hinc & Hinf).
assert (Hall : forall t, t0 <= t -> y t < z t) by (intros t Ht; apply (Late t Ht)).
refine (conj Hall (conj Hinc (conj Hinf _))).
apply (penetrate eps t0 y z (fun t => contact_force eps (y t) (z t)) He); auto.
- intros t Ht. apply (H t Ht).
- intros t Ht. apply Hall. lra.
Qed.

Lemma slow_comes_into_cone a1 a2 a3 eps C p b y v z : parameters a1 a3 eps -> 0 < C * Gamma (- (a3 / a1)) ->
  slow_motion a1 a2 a3 eps C p b y v z ->
  exists T, forall t, T <= t -> p t <= - (6 - 2 * a3 * eps) /\ y t < z t /\ late_cone a1 a2 a3 eps (p t) (b t) (y t)
    (v t) (z t).
Proof.
intros Hpar HC HS.
assert (Ha1 := par1 a1 a3 eps Hpar). assert (Ha3 := par3 a1 a3 eps Hpar). assert (He := par_eps a1 a3 eps Hpar).
assert (Hb := par_beta a1 a3 eps Hpar).
destruct (slow_in_late_cone a1 a2 a3 eps C Ha1 Ha3 He Hb HC) as (T1 & HT1 & Hcone).
destruct (side_rule_up a1 a2 a3 eps C Ha1 Ha3 He Hb HC 1) as (T2 & Hforce).
exists (Rmax (Rmax T1 T2) ((6 - 2 * a3 * eps) / - a1)). intros t Ht.
assert (M1 := Rmax_l (Rmax T1 T2) ((6 - 2 * a3 * eps) / - a1)).
assert (M2 := Rmax_r (Rmax T1 T2) ((6 - 2 * a3 * eps) / - a1)).
assert (M3 := Rmax_l T1 T2). assert (M4 := Rmax_r T1 T2).
destruct (slow_motion_is_sol a1 a2 a3 eps Hpar C p b y v z HS t) as (-> & -> & F3 & -> & F5 & Fl).
refine (conj _ (conj _ _)).
- unfold sol_p, rec_p. apply Ropp_le_cancel. rewrite Ropp_involutive.
  replace (6 - 2 * a3 * eps) with (- a1 * ((6 - 2 * a3 * eps) / - a1)) by (field; lra).
  replace (- (a1 * t)) with (- a1 * t) by ring. apply Rmult_le_compat_l; lra.
- apply (linear_force_pos eps); auto. rewrite Fl. specialize (Hforce t ltac:(lra)). lra.
- rewrite F3, F5. apply Hcone. lra.
Qed.

Lemma continuous_bounds (f : R -> R) a d : a <= d -> (forall t, a <= t <= d -> ex_derive f t) ->
  (forall t, a <= t <= d -> 0 < f t) ->
  exists m M, 0 < m /\ 0 <= M /\ forall t, a <= t <= d -> m <= f t <= M.
Proof.
intros Had Hf Hp.
assert (HC : forall c, a <= c <= d -> continuity_pt f c).
{ intros c Hc. apply continuity_pt_filterlim, (ex_derive_continuous f c), Hf, Hc. }
destruct (continuity_ab_min f a d Had HC) as (u & Hu & Du). destruct (continuity_ab_maj f a d Had HC) as (w & Hw & Dw).
exists (f u), (f w). refine (conj (Hp u Du) (conj (Rlt_le _ _ (Hp w Dw)) _)). intros t Ht. split; auto.
Qed.

Lemma sq_le_abs x r : 0 <= r -> x ^ 2 <= r ^ 2 -> Rabs x <= r.
Proof. intros Hr H. rewrite <- (Rabs_pos_eq r) by auto. apply Rsqr_le_abs_0. unfold Rsqr. simpl in H. lra. Qed.

Lemma abs_le_sq x r : Rabs x <= r -> x ^ 2 <= r ^ 2.
Proof. intros H. rewrite <- (pow2_abs x). apply pow_incr. split; auto using Rabs_pos. Qed.

Section Stable.
Variables (a1 a2 a3 eps t0 : R) (P B Y V Z : R -> R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Ha13 : a1 <> a3.
Hypothesis He : 0 < eps.
Hypothesis HP : forall t, t0 <= t -> P t = a1 * t.
Hypothesis reference_model : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force P B Y V Z t.
Hypothesis Hcontact : forall t, t0 <= t -> Y t < Z t.
Hypothesis Hcone : exists T, forall t, T <= t -> late_cone a1 a2 a3 eps (P t) (B t) (Y t) (V t) (Z t).

(** Until any time te: motions that start within delta stay within r. *)
Lemma near_until te r : t0 <= te -> 0 < r <= 1 -> exists delta, 0 < delta /\ forall p b y v z,
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta -> forall t, t0 <= t <= te ->
  Rabs (p t - P t) <= r /\ Rabs (b t - B t) <= r /\ Rabs (y t - Y t) <= r /\ Rabs (v t - V t) <= r /\
    Rabs (z t - Z t) <= r.
Proof.
intros Hte Hr.
destruct (continuous_bounds (fun t => (Z t - Y t) / eps ^ 2) t0 te Hte) as (m & M & Hm & HM & HB).
{ intros t Ht. destruct (reference_model t (proj1 Ht)) as (_ & _ & Dy & _ & Dz).
  assert (Xz : ex_derive Z t).
  { exists (/ eps * (- Z t - eps ^ 2 * contact_force eps (Y t) (Z t))).
    apply (is_derive_ext (fun s => / eps * (eps * Z s))).
    { intros s. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
    apply (is_derive_scal (fun s => eps * Z s)), Dz. }
  assert (Xy : ex_derive Y t) by (eexists; exact Dy). auto_derive. auto. }
{ intros t Ht. apply Rdiv_lt_0_compat; [generalize (Hcontact t (proj1 Ht)); lra|apply pow_lt, He]. }
set (Pm := Rabs a1 * (Rabs t0 + Rabs te) + 1).
set (K := 2 * Rabs a3 * / eps ^ 2 + 3 + 2 * Pm * / eps ^ 2 + 3 / eps + 2 * eps * / eps ^ 2).
set (G := exp (K * (te - t0))).
assert (Hq : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He).
assert (HPm : 0 <= Pm).
{ unfold Pm. assert (0 <= Rabs a1 * (Rabs t0 + Rabs te))
    by (apply Rmult_le_pos; generalize (Rabs_pos a1) (Rabs_pos t0) (Rabs_pos te); lra). lra. }
assert (HK : 0 <= K).
{ unfold K. assert (0 <= Rabs a3 * / eps ^ 2) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
  assert (0 <= Pm * / eps ^ 2) by (apply Rmult_le_pos; lra).
  assert (0 < eps * / eps ^ 2) by (apply Rmult_lt_0_compat; lra).
  assert (0 < 3 / eps) by (apply Rdiv_lt_0_compat; lra). lra. }
assert (HG : 1 <= G).
{ unfold G. rewrite <- exp_0. apply exp_le. apply Rmult_le_pos; lra. }
set (A := (4 + M ^ 2) * G).
assert (HA : 1 <= A).
{ unfold A. generalize (pow2_ge_0 M). intros. assert (1 * 1 <= (4 + M ^ 2) * G) by (apply Rmult_le_compat; lra). lra. }
assert (HA1 : 0 < / A) by (apply Rinv_0_lt_compat; lra).
assert (HA2 : / A <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
set (delta := r * / A).
assert (Hd : 0 < delta) by (apply Rmult_lt_0_compat; lra).
assert (Hdr : delta <= r) by (unfold delta; rewrite <- (Rmult_1_r r) at 2; apply Rmult_le_compat_l; lra).
exists delta. split; auto. intros p b y v z H Ip Ib Iy Iv Iz.
assert (Ep : forall t, t0 <= t -> p t - P t = p t0 - P t0).
{ intros t Ht. destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hlt|<-]; auto. symmetry.
  apply (eq_is_derive (fun s => p s - P s) t0 t); auto. intros s Hs.
  eapply is_derive_val. apply (is_derive_minus p P s a1 a1). apply (H s); lra. apply (reference_model s); lra.
  unfold minus, plus, opp, zero; simpl. ring. }
assert (Bp : forall t, t0 <= t <= te -> Rabs (p t) <= Pm).
{ intros t Ht. replace (p t) with ((p t - P t) + P t) by ring. rewrite (Ep t) by lra.
  rewrite (HP t) by lra. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_mult. unfold Pm.
  assert (Rabs t <= Rabs t0 + Rabs te).
  { generalize (Rabs_pos t0) (Rabs_pos te) (Rle_abs te) (Rle_abs (- t0)). rewrite Rabs_Ropp. intros.
    apply Rabs_le. lra. }
  assert (Rabs a1 * Rabs t <= Rabs a1 * (Rabs t0 + Rabs te)) by (apply Rmult_le_compat_l; auto using Rabs_pos). lra. }
set (eta := (delta * M) ^ 2).
assert (Heta : forall t, t0 <= t <= te -> ((p t - P t) * contact_force eps (Y t) (Z t)) ^ 2 <= eta).
{ intros t Ht. apply abs_le_sq. rewrite Rabs_mult, (Ep t) by lra. destruct (HB t Ht) as (B1 & B2).
  assert (E : contact_force eps (Y t) (Z t) = (Z t - Y t) / eps ^ 2).
  { unfold contact_force. destruct (Rlt_dec (Y t) (Z t)) as [_|N]; auto. exfalso. apply N, Hcontact. lra. }
  rewrite E, (Rabs_pos_eq ((Z t - Y t) / eps ^ 2)) by lra. apply Rmult_le_compat; try lra. apply Rabs_pos. }
assert (Mc := motions_close a1 a2 a3 eps He p b y v z P B Y V Z t0 te Pm eta (fun t Ht => H t (proj1 Ht))
  (fun t Ht => reference_model t (proj1 Ht)) Bp Heta).
cbv beta zeta in Mc. fold K in Mc.
assert (E0 : (b t0 - B t0) ^ 2 + (y t0 - Y t0) ^ 2 + (v t0 - V t0) ^ 2 + (z t0 - Z t0) ^ 2 + eta
  <= (4 + M ^ 2) * delta ^ 2).
{ assert (S1 := abs_le_sq _ _ (Rlt_le _ _ Ib)). assert (S2 := abs_le_sq _ _ (Rlt_le _ _ Iy)).
  assert (S3 := abs_le_sq _ _ (Rlt_le _ _ Iv)). assert (S4 := abs_le_sq _ _ (Rlt_le _ _ Iz)).
  replace ((4 + M ^ 2) * delta ^ 2) with (delta ^ 2 + delta ^ 2 + delta ^ 2 + delta ^ 2 + eta) by (unfold eta; ring).
  lra. }
intros t Ht. specialize (Mc t Ht).
assert (Fin : (b t - B t) ^ 2 + (y t - Y t) ^ 2 + (v t - V t) ^ 2 + (z t - Z t) ^ 2 + eta <= r ^ 2).
{ eapply Rle_trans; [exact Mc|]. apply Rle_trans with ((4 + M ^ 2) * delta ^ 2 * G).
  - apply Rmult_le_compat; auto.
    + assert (0 <= eta) by apply pow2_ge_0.
      generalize (pow2_ge_0 (b t0 - B t0)) (pow2_ge_0 (y t0 - Y t0)) (pow2_ge_0 (v t0 - V t0))
        (pow2_ge_0 (z t0 - Z t0)). lra.
    + apply Rlt_le, exp_pos.
    + apply exp_le. apply Rmult_le_compat_l; lra.
  - replace ((4 + M ^ 2) * delta ^ 2 * G) with (r ^ 2 * / A).
    2: { replace ((4 + M ^ 2) * delta ^ 2 * G) with (A * delta ^ 2) by (unfold A; ring). unfold delta. field. lra. }
    rewrite <- (Rmult_1_r (r ^ 2)) at 2. apply Rmult_le_compat_l; [apply pow2_ge_0|lra]. }
assert (0 <= eta) by apply pow2_ge_0.
assert (N1 := pow2_ge_0 (b t - B t)). assert (N2 := pow2_ge_0 (y t - Y t)). assert (N3 := pow2_ge_0 (v t - V t)).
assert (N4 := pow2_ge_0 (z t - Z t)).
refine (conj _ (conj _ (conj _ (conj _ _)))); try (apply sq_le_abs; lra).
rewrite (Ep t) by lra. lra.
Qed.

Theorem stable : exists delta, 0 < delta /\ forall p b y v z,
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
destruct Hcone as (T1 & HT1).
set (te := Rmax (Rmax t0 T1) ((6 - 2 * a3 * eps + 1) / - a1)).
assert (M1 := Rmax_l (Rmax t0 T1) ((6 - 2 * a3 * eps + 1) / - a1)).
assert (M2 := Rmax_r (Rmax t0 T1) ((6 - 2 * a3 * eps + 1) / - a1)).
assert (M3 := Rmax_l t0 T1). assert (M4 := Rmax_r t0 T1). fold te in M1, M2.
assert (HCt := HT1 te ltac:(lra)).
assert (HPt : P te <= - (6 - 2 * a3 * eps + 1)).
{ rewrite HP by lra. apply Ropp_le_cancel. rewrite Ropp_involutive.
  replace (6 - 2 * a3 * eps + 1) with (- a1 * ((6 - 2 * a3 * eps + 1) / - a1)) by (field; lra).
  replace (- (a1 * te)) with (- a1 * te) by ring. apply Rmult_le_compat_l; lra. }
destruct (late_cone_open a1 a2 a3 eps _ _ _ _ _ Ha13 He HCt) as (r1 & Hr1 & Hopen).
destruct (continuous_bounds (fun t => Z t - Y t) t0 te ltac:(lra)) as (m & M & Hm & HM & HB).
{ intros t Ht. destruct (reference_model t (proj1 Ht)) as (_ & _ & Dy & _ & Dz).
  assert (Xz : ex_derive Z t).
  { exists (/ eps * (- Z t - eps ^ 2 * contact_force eps (Y t) (Z t))).
    apply (is_derive_ext (fun s => / eps * (eps * Z s))).
    { intros s. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
    apply (is_derive_scal (fun s => eps * Z s)), Dz. }
  assert (Xy : ex_derive Y t) by (eexists; exact Dy). auto_derive. auto. }
{ intros t Ht. generalize (Hcontact t (proj1 Ht)). lra. }
set (r := Rmin r1 (m / 3)). assert (R1 := Rmin_l r1 (m / 3)). assert (R2 := Rmin_r r1 (m / 3)). fold r in R1, R2.
assert (Hr : 0 < r) by (apply Rmin_pos; lra).
destruct (near_until te r ltac:(lra) ltac:(lra)) as (delta & Hd & Hnear).
exists delta. split; auto. intros p b y v z H Ip Ib Iy Iv Iz.
specialize (Hnear p b y v z H Ip Ib Iy Iv Iz).
assert (Early : forall t, t0 <= t <= te -> y t < z t).
{ intros t Ht. destruct (Hnear t Ht) as (_ & _ & Ny & _ & Nz). destruct (HB t Ht) as (B1 & _).
  apply Rabs_le_between in Ny, Nz. lra. }
destruct (Hnear te ltac:(lra)) as (Np & Nb & Ny & Nv & Nz).
assert (Hpe : p te <= - (6 - 2 * a3 * eps)) by (apply Rabs_le_between in Np; lra).
assert (Hm' : forall t, te <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) by (intros t Ht; apply H; lra).
destruct (late_IWC a1 a2 a3 eps te p b y v z Ha1 Ha3 Ha13 He Hm' Hpe (Early te ltac:(lra)) ltac:(apply Hopen; lra))
  as (Late & _ & Hinf & Hy).
refine (conj _ (conj Hinf Hy)). intros t Ht. destruct (Rle_lt_dec t te) as [Hl|Hl]; [apply Early; lra|]. apply (Late t).
lra.
Qed.

End Stable.

(** The case of a slow motion. *)
Theorem stable_slow a1 a2 a3 eps C t0 P B Y V Z : parameters a1 a3 eps -> 0 < C * Gamma (- (a3 / a1)) ->
  slow_motion a1 a2 a3 eps C P B Y V Z -> (forall t, t0 <= t -> Y t < Z t) ->
  exists delta, 0 < delta /\ forall p b y v z, (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros Hpar HC HS Hc. assert (Ha1 := par1 a1 a3 eps Hpar). assert (He := par_eps a1 a3 eps Hpar).
destruct (slow_comes_into_cone a1 a2 a3 eps C P B Y V Z Hpar HC HS) as (T & HT). destruct HS as (HP & Hm & _).
apply (stable a1 a2 a3 eps t0 P B Y V Z Ha1 (par3 a1 a3 eps Hpar) (a13 a1 a3 Ha1 (par_beta a1 a3 eps Hpar)) He
  (fun t _ => HP t)); auto.
- intros t Ht. assert (E : contact_force eps (Y t) (Z t) = linear_force eps (Y t) (Z t)).
  { apply contact_force_in_contact; auto. apply Rlt_le, linear_force_pos; auto. }
  specialize (Hm t). unfold model_at in *. rewrite E. exact Hm.
- exists T. intros t Ht. apply HT, Ht.
Qed.
