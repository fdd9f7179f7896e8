(** * The compliant model: flights

    From lift-off on, while y >= z, the motion is b = b0 + a2 u, y a cubic, z = z0 e^(-u/eps), u the time since. The
    second derivative of the gap y - z does not increase if z0 <= 0: so the gap has one later zero at most, and there it
    decreases ([one_return]). For a2 < 0 it has one, since the cubic tends to -oo ([flight_ends]); for a2 >= 0 and b0 >=
    0 the gap increases for ever ([flight_never_ends]). *)

From Coq Require Import Reals Psatz Lra Lia.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant Calculus CompliantDependence InitialValueProblem CompliantMotion.
Open Scope R_scope.

Lemma derive_neg_after (f : R -> R) t l : is_derive f t l -> f t = 0 -> l < 0 -> exists d, 0 < d /\ forall s,
  t < s < t + d -> f s < 0.
Proof.
intros D E Hl. apply is_derive_Reals in D. destruct (D (- l) ltac:(lra)) as (d & Hd).
exists d. split. apply cond_pos. intros s Hs.
specialize (Hd (s - t) ltac:(lra)). rewrite Rabs_pos_eq in Hd by lra. specialize (Hd ltac:(lra)).
replace (t + (s - t)) with s in Hd by ring. rewrite E, Rminus_0_r in Hd.
apply Rabs_def2 in Hd. destruct Hd as [Hd _].
assert (Hq : f s / (s - t) < 0) by lra.
replace (f s) with (f s / (s - t) * (s - t)) by (field; lra).
assert (0 < - (f s / (s - t)) * (s - t)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** h(0) = 0, h'(0) > 0, h'' does not increase, h is negative somewhere: h has one zero u > 0, h' < 0 there, and h > 0
    before. *)
Section Return.
Variables h h1 h2 : R -> R.
Hypothesis D0 : forall u, is_derive h u (h1 u).
Hypothesis D1 : forall u, is_derive h1 u (h2 u).
Hypothesis Hstart : h 0 = 0.
Hypothesis Hup : 0 < h1 0.

Lemma never_back : (forall u, 0 <= u -> 0 <= h2 u) -> forall u, 0 < u -> 0 < h u.
Proof.
intros H u Hu. destruct (mvt_open h h1 0 u Hu (fun s _ => D0 s)) as (c & Hc & E).
destruct (mvt_open h1 h2 0 c ltac:(lra) (fun s _ => D1 s)) as (e & He & E').
specialize (H e ltac:(lra)).
assert (0 <= h2 e * (c - 0)) by (apply Rmult_le_pos; lra).
assert (0 < h1 c * (u - 0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Hypothesis Hconcave : forall s t, 0 <= s <= t -> h2 t <= h2 s.

Lemma stays_down s t : 0 < s < t -> h1 s <= 0 -> h1 t < 0.
Proof.
intros Hs H.
destruct (mvt_open h1 h2 0 s ltac:(lra) (fun s _ => D1 s)) as (c & Hc & E).
destruct (mvt_open h1 h2 s t ltac:(lra) (fun s _ => D1 s)) as (e & He & E').
assert (N : h2 c < 0).
{ apply Rnot_le_lt. intros H0. assert (0 <= h2 c * (s - 0)) by (apply Rmult_le_pos; lra). lra. }
specialize (Hconcave c e ltac:(lra)).
assert (0 < - h2 e * (t - s)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Theorem one_return : (exists u, 0 < u /\ h u < 0) ->
  exists u, 0 < u /\ h u = 0 /\ h1 u < 0 /\ (forall s, 0 < s < u -> 0 < h s).
Proof.
intros (U & HU & HN).
destruct (derive_neg_after (fun s => - h s) 0 (- h1 0)) as (d & Hd & Hsmall); try lra.
{ apply (is_derive_opp h), D0. }
set (s := Rmin (d / 2) (U / 2)).
assert (S1 : s <= d / 2) by apply Rmin_l. assert (S2 : s <= U / 2) by apply Rmin_r.
assert (S0 : 0 < s) by (apply Rmin_pos; lra).
specialize (Hsmall s ltac:(lra)).
destruct (IVT_cor h s U (derive_continuity h h1 D0) ltac:(lra)) as (u & Hu & E). { nra. }
exists u. assert (u0 : 0 < u) by lra.
refine (conj u0 (conj E (conj _ _))).
- destruct (mvt_open h h1 0 u u0 (fun s _ => D0 s)) as (c & Hc & Em).
  apply (stays_down c u Hc). rewrite E, Hstart in Em.
  assert (h1 c = 0); [|lra]. apply Rmult_eq_reg_r with (u - 0); lra.
- intros r Hr. apply Rnot_le_lt. intros H.
  destruct (mvt_open h h1 0 r ltac:(lra) (fun s _ => D0 s)) as (c & Hc & Em).
  destruct (mvt_open h h1 r u ltac:(lra) (fun s _ => D0 s)) as (e & He & Em').
  assert (Hc1 : h1 c <= 0).
  { apply Rnot_lt_le. intros H0. assert (0 < h1 c * (r - 0)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (N := stays_down c e ltac:(lra) Hc1).
  assert (0 < - h1 e * (u - r)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

End Return.

(** ** The motion in flight *)
Section Flight.
Variables (a1 a2 a3 eps : R).
Hypothesis Heps : 0 < eps.
Variables p b y v z : R -> R.
Variable t0 : R.
Hypothesis Hm : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.
Hypothesis Htouch : y t0 = z t0.
Hypothesis Hup : 0 < v t0 + z t0 / eps.

Definition flight_p (t : R) : R := p t0 + a1 * (t - t0).
Definition flight_b (t : R) : R := b t0 + a2 * (t - t0).
Definition flight_v (t : R) : R := v t0 + b t0 * (t - t0) + a2 * (t - t0) ^ 2 / 2.
Definition flight_y (t : R) : R := y t0 + v t0 * (t - t0) + b t0 * (t - t0) ^ 2 / 2 + a2 * (t - t0) ^ 3 / 6.
Definition flight_z (t : R) : R := z t0 * exp (- (t - t0) / eps).

Lemma flight_model t : flight_z t <= flight_y t -> model_at a1 a2 a3 eps contact_force flight_p flight_b flight_y
  flight_v flight_z t.
Proof.
intros H. unfold model_at.
assert (E : contact_force eps (flight_y t) (flight_z t) = 0).
{ unfold contact_force. destruct Rlt_dec; auto. lra. }
rewrite E. unfold flight_p, flight_b, flight_y, flight_v, flight_z.
refine (conj _ (conj _ (conj _ (conj _ _)))); auto_derive; auto; try ring; try (field; lra).
unfold Rdiv, Rminus. set (X := exp _).
clearbody X. generalize (z t0). intros start. field. lra.
Qed.

(** The gap, as a function of the time since lift-off, with two derivatives. *)
Definition gap (u : R) : R := y t0 + v t0 * u + b t0 * u ^ 2 / 2 + a2 * u ^ 3 / 6 - z t0 * exp (- u / eps).
Definition gap1 (u : R) : R := v t0 + b t0 * u + a2 * u ^ 2 / 2 + z t0 / eps * exp (- u / eps).
Definition gap2 (u : R) : R := b t0 + a2 * u - z t0 / eps ^ 2 * exp (- u / eps).

Lemma gap_derive u : is_derive gap u (gap1 u).
Proof. unfold gap, gap1, Rdiv. auto_derive; auto. simpl. set (X := exp _). clearbody X. field. lra. Qed.

Lemma gap1_derive u : is_derive gap1 u (gap2 u).
Proof. unfold gap1, gap2, Rdiv. auto_derive; auto. simpl. set (X := exp _). clearbody X. field. lra. Qed.

Lemma gap_start : gap 0 = 0 /\ 0 < gap1 0.
Proof.
unfold gap, gap1. replace (- 0 / eps) with 0 by (field; lra). rewrite exp_0, Htouch. split; [field; lra|]. lra.
Qed.

Lemma gap_flight t : gap (t - t0) = flight_y t - flight_z t.
Proof. unfold gap, flight_y, flight_z. ring. Qed.

Hypothesis Hz : z t0 <= 0.

Lemma exp_flight s t : s <= t -> exp (- t / eps) <= exp (- s / eps).
Proof.
intros H. apply exp_le. unfold Rdiv. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, Heps. lra.
Qed.

Lemma follows_flight te : (forall t, t0 <= t <= te -> flight_z t <= flight_y t) -> forall t, t0 <= t <= te ->
  b t = flight_b t /\ y t = flight_y t /\ v t = flight_v t /\ z t = flight_z t.
Proof.
intros H t Ht.
assert (Ez : z t0 = flight_z t0).
{ unfold flight_z. replace (- (t0 - t0) / eps) with 0 by (field; lra). rewrite exp_0. ring. }
assert (Ep : p t0 = flight_p t0) by (unfold flight_p; ring).
assert (Eb : b t0 = flight_b t0) by (unfold flight_b; ring).
assert (Ey : y t0 = flight_y t0) by (unfold flight_y; field).
assert (Ev : v t0 = flight_v t0) by (unfold flight_v; field).
destruct (forward_unique a1 a2 a3 eps Heps p b y v z flight_p flight_b flight_y flight_v flight_z t0 te
  (fun s Hs => Hm s (proj1 Hs)) (fun s Hs => flight_model s (H s Hs)) Ep Eb Ey Ev Ez t Ht) as (_ & A). exact A.
Qed.

Theorem flight_never_ends : 0 <= a2 -> 0 <= b t0 -> forall t, t0 < t ->
  z t < y t /\ b t = flight_b t /\ y t = flight_y t /\ v t = flight_v t /\ z t = flight_z t.
Proof.
intros H2 Hb.
assert (G : forall u, 0 < u -> 0 < gap u).
{ destruct gap_start. apply (never_back gap gap1 gap2 gap_derive gap1_derive); auto.
  intros u Hu. unfold gap2. assert (He := exp_pos (- u / eps)).
  assert (0 <= a2 * u) by (apply Rmult_le_pos; lra).
  assert (0 <= / eps ^ 2) by (apply Rlt_le, Rinv_0_lt_compat, pow_lt, Heps).
  assert (0 <= - z t0 * / eps ^ 2 * exp (- u / eps)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  unfold Rdiv at 1. lra. }
intros t Ht.
assert (F : b t = flight_b t /\ y t = flight_y t /\ v t = flight_v t /\ z t = flight_z t).
{ apply (follows_flight t); [|lra]. intros s Hs. destruct (Rle_lt_or_eq_dec t0 s (proj1 Hs)) as [Hl|<-].
  - generalize (G (s - t0) ltac:(lra)) (gap_flight s). lra.
  - generalize (gap_flight t0) (proj1 gap_start). rewrite Rminus_eq_0. lra. }
split; auto. destruct F as (_ & -> & _ & ->). generalize (G (t - t0) ltac:(lra)) (gap_flight t). lra.
Qed.

Theorem flight_persists : 0 < a2 -> 0 <= b t0 -> forall s t, t0 <= s -> s < t -> z t < y t /\ b s < b t /\ v s < v t /\
  y s < y t.
Proof.
intros H2 Hb s t Hs Hst.
assert (F : b s = flight_b s /\ y s = flight_y s /\ v s = flight_v s).
{ destruct (Rle_lt_or_eq_dec _ _ Hs) as [Hl|<-].
  - destruct (flight_never_ends (Rlt_le _ _ H2) Hb s Hl) as (_ & Fb & Fy & Fv & _). auto.
  - unfold flight_b, flight_y, flight_v. repeat split; field. }
destruct F as (-> & -> & ->). destruct (flight_never_ends (Rlt_le _ _ H2) Hb t ltac:(lra)) as (N & -> & Fy & -> & _).
split; auto. rewrite Fy. unfold flight_b, flight_y, flight_v.
assert (V0 : 0 < v t0).
{ assert (0 <= - z t0 * / eps) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, Heps]). unfold Rdiv in Hup.
  lra. }
set (h := s - t0) in *. set (k := t - s). assert (Hh : 0 <= h) by (unfold h; lra).
assert (Hk : 0 < k) by (unfold k; lra).
replace (t - t0) with (h + k) by (unfold h, k; ring).
assert (K1 : 0 < a2 * k) by (apply Rmult_lt_0_compat; lra). assert (K2 : 0 <= b t0 * k) by (apply Rmult_le_pos; lra).
assert (K3 : 0 < v t0 * k) by (apply Rmult_lt_0_compat; lra).
assert (K4 : 0 <= a2 * k * h) by (apply Rmult_le_pos; lra).
assert (K5 : 0 < a2 * k * k) by (apply Rmult_lt_0_compat; lra).
assert (K6 : 0 <= b t0 * k * h) by (apply Rmult_le_pos; lra).
assert (K7 : 0 <= b t0 * k * k) by (apply Rmult_le_pos; lra).
assert (K8 : 0 <= a2 * k * h * h) by (apply Rmult_le_pos; lra).
assert (K9 : 0 <= a2 * k * h * k) by (apply Rmult_le_pos; lra).
assert (K10 : 0 < a2 * k * k * k) by (apply Rmult_lt_0_compat; lra).
repeat split; lra.
Qed.

Lemma gap_negative : a2 < 0 \/ a2 = 0 /\ b t0 < 0 -> exists u, 0 < u /\ gap u < 0.
Proof.
intros H.
assert (B : forall u, 0 < u -> v t0 + b t0 * u / 2 + a2 * u ^ 2 / 6 < 0 -> gap u < 0).
{ intros u Hu Hn. unfold gap. rewrite Htouch.
  assert (E1 := exp_flight 0 u ltac:(lra)). replace (- 0 / eps) with 0 in E1 by (field; lra). rewrite exp_0 in E1.
  assert (0 <= - z t0 * (1 - exp (- u / eps))) by (apply Rmult_le_pos; lra).
  assert (0 < - (v t0 + b t0 * u / 2 + a2 * u ^ 2 / 6) * u) by (apply Rmult_lt_0_compat; lra).
  replace (- (v t0 + b t0 * u / 2 + a2 * u ^ 2 / 6) * u) with (- (v t0 * u + b t0 * u ^ 2 / 2 + a2 * u ^ 3 / 6)) in *
    by field. lra. }
assert (V := Rle_abs (v t0)). assert (V0 := Rabs_pos (v t0)). assert (B1 := Rle_abs (b t0)).
assert (B0 := Rabs_pos (b t0)).
destruct H as [H|[H Hb]].
- set (q := 6 * (Rabs (v t0) + Rabs (b t0)) / - a2).
  assert (Hq : 0 <= q) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]).
  assert (Eq : - a2 * q = 6 * (Rabs (v t0) + Rabs (b t0))) by (unfold q; field; lra).
  exists (q + 1). split. lra. apply B. lra.
  assert (0 <= (Rabs (b t0) - b t0) * (q + 1)) by (apply Rmult_le_pos; lra).
  assert (0 <= Rabs (v t0) * q) by (apply Rmult_le_pos; lra).
  assert (0 <= Rabs (b t0) * q) by (apply Rmult_le_pos; lra).
  assert (Es : a2 * (q + 1) ^ 2 = (- (- a2 * q) + a2) * (q + 1)) by ring.
  rewrite Es, Eq. assert (0 <= - a2 * q) by (apply Rmult_le_pos; lra). lra.
- set (q := 2 * Rabs (v t0) / - b t0).
  assert (Hq : 0 <= q) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]).
  exists (q + 1). split. lra. apply B. lra. rewrite H.
  assert (Eq : b t0 * q = - 2 * Rabs (v t0)) by (unfold q; field; lra). lra.
Qed.

Theorem flight_ends : a2 < 0 \/ a2 = 0 /\ b t0 < 0 -> exists t1 d, t0 < t1 /\ 0 < d /\
  (forall t, t0 < t < t1 -> z t < y t) /\ y t1 = z t1 /\ v t1 + z t1 / eps < 0 /\
    (forall t, t1 < t < t1 + d -> y t < z t) /\
  forall t, t0 <= t <= t1 -> b t = flight_b t /\ y t = flight_y t /\ v t = flight_v t /\ z t = flight_z t.
Proof.
intros H. destruct gap_start as (G0 & G1).
destruct (one_return gap gap1 gap2 gap_derive gap1_derive G0 G1) as (u & Hu & E & Hd & Hpos).
{ intros s t Hst. unfold gap2.
  assert (a2 * t <= a2 * s) by (destruct H as [H|[H _]]; [nra|rewrite H; lra]).
  assert (Ex := exp_flight s t (proj2 Hst)).
  assert (0 <= / eps ^ 2) by (apply Rlt_le, Rinv_0_lt_compat, pow_lt, Heps).
  assert (0 <= - z t0 * / eps ^ 2 * (exp (- s / eps) - exp (- t / eps))) by (apply Rmult_le_pos; [apply Rmult_le_pos|];
    lra).
  unfold Rdiv in *. lra. }
{ apply gap_negative, H. }
assert (F : forall t, t0 <= t <= t0 + u -> b t = flight_b t /\ y t = flight_y t /\ v t = flight_v t /\
  z t = flight_z t).
{ apply follows_flight. intros t Ht. assert (Eg := gap_flight t).
  destruct (Req_dec t t0) as [->|N0]. { rewrite Rminus_eq_0 in Eg. lra. }
  destruct (Req_dec t (t0 + u)) as [->|N1]. { replace (t0 + u - t0) with u in Eg by ring. lra. }
  specialize (Hpos (t - t0) ltac:(lra)). lra. }
destruct (F (t0 + u) ltac:(lra)) as (Fb & Fy & Fv & Fz).
assert (Et : y (t0 + u) = z (t0 + u)).
{ rewrite Fy, Fz. assert (Eg := gap_flight (t0 + u)). replace (t0 + u - t0) with u in Eg by ring. lra. }
assert (Ed : v (t0 + u) + z (t0 + u) / eps < 0).
{ rewrite Fv, Fz. unfold flight_v, flight_z. replace (t0 + u - t0) with u by ring. unfold gap1 in Hd. unfold Rdiv in *.
  lra. }
destruct (derive_neg_after (fun s => y s - z s) (t0 + u) (v (t0 + u) + z (t0 + u) / eps)) as (d & Hd0 & Hafter); auto;
  try lra.
{ destruct (Hm (t0 + u) ltac:(lra)) as (_ & _ & Dy & _ & Dz).
  assert (E0 : contact_force eps (y (t0 + u)) (z (t0 + u)) = 0) by (unfold contact_force; destruct Rlt_dec; auto; lra).
  rewrite E0 in Dz. eapply is_derive_val. apply (is_derive_minus y z). exact Dy. apply (z_derive eps Heps), Dz.
  unfold minus, plus, opp; simpl. field. lra. }
exists (t0 + u), d.
refine (conj _ (conj Hd0 (conj _ (conj Et (conj Ed (conj _ F)))))). lra.
- intros t Ht. destruct (F t ltac:(lra)) as (_ & -> & _ & ->).
  specialize (Hpos (t - t0) ltac:(lra)). generalize (gap_flight t). lra.
- intros t Ht. specialize (Hafter t Ht). lra.
Qed.

End Flight.

(** z <= 0 at one time: ever after, since (z e^(t/eps))' = - eps (force) e^(t/eps) <= 0. *)
Lemma contact_force_nonnegative eps y z : 0 < eps -> 0 <= contact_force eps y z.
Proof.
intros He. unfold contact_force. destruct Rlt_dec; [|lra].
apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, He.
Qed.

Lemma z_weighted (eps lo hi : R) (z force : R -> R) : 0 < eps -> lo <= hi ->
  (forall t, lo <= t <= hi -> is_derive (fun s => eps * z s) t (- z t - eps ^ 2 * force t)) ->
    (forall t, lo <= t <= hi -> 0 <= force t) ->
  z hi * exp (hi / eps) <= z lo * exp (lo / eps).
Proof.
intros He Hlh D Hf.
apply (decr_of_derive (fun t => z t * exp (t / eps)) (fun t => - (eps * force t * exp (t / eps))) lo hi Hlh).
- intros t Ht. eapply is_derive_val.
  + apply (is_derive_mult_R z (fun t => exp (t / eps)) t (/ eps * (- z t - eps ^ 2 * force t)) (/ eps * exp (t / eps))).
    apply (z_derive eps He), D, Ht. auto_derive; auto. unfold Rdiv; ring.
  + field. lra.
- intros t Ht. assert (0 <= eps * force t * exp (t / eps)); [|lra].
  apply Rmult_le_pos; [apply Rmult_le_pos|]. lra. auto. apply Rlt_le, exp_pos.
Qed.

Theorem z_stays_nonpositive (a1 a2 a3 eps : R) (p b y v z : R -> R) t0 t : 0 < eps -> 
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) -> z t0 <= 0 -> t0 <= t -> z t <= 0.
Proof.
intros He Hm Hz Ht.
assert (W := z_weighted eps t0 t z (fun s => contact_force eps (y s) (z s)) He Ht).
assert (E0 := exp_pos (t0 / eps)). assert (E1 := exp_pos (t / eps)).
assert (z t * exp (t / eps) <= z t0 * exp (t0 / eps)).
{ apply W. intros s Hs. apply (Hm s). lra. intros s _. apply contact_force_nonnegative, He. }
assert (0 <= - z t0 * exp (t0 / eps)) by (apply Rmult_le_pos; lra).
apply Rnot_lt_le. intros Hpos. assert (0 < z t * exp (t / eps)) by (apply Rmult_lt_0_compat; auto). lra.
Qed.
