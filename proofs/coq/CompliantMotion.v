(** * The compliant model: the motion through a state

    A law of force that is Lipschitz in (y, z), as compl2 and the force without condition are: through every state at
    every time there is exactly one motion on the whole line ([motion_exists], [motion_unique]). p is affine; b, y, v, z
    solve an initial value problem. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant Calculus CompliantDependence InitialValueProblem.
Import ListNotations.
Open Scope R_scope.

Definition lipschitz_force (force : R -> R -> R) : Prop := exists K, 0 <= K /\ forall y z y' z',
  Rabs (force y z - force y' z') <= K * (Rabs (y - y') + Rabs (z - z')).

Lemma contact_lipschitz eps : 0 < eps -> lipschitz_force (contact_force eps).
Proof.
intros He. exists (/ eps ^ 2). split. apply Rlt_le, Rinv_0_lt_compat, pow_lt, He. intros y z y' z'.
apply contact_force_lipschitz, He.
Qed.

Lemma linear_lipschitz eps : 0 < eps -> lipschitz_force (linear_force eps).
Proof.
intros He. assert (Hi : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He).
exists (/ eps ^ 2). split. lra. intros y z y' z'. unfold linear_force.
replace ((z - y) / eps ^ 2 - (z' - y') / eps ^ 2) with (/ eps ^ 2 * ((z - z') - (y - y'))) by (unfold Rdiv; ring).
rewrite Rabs_mult, (Rabs_pos_eq (/ eps ^ 2)) by lra. apply Rmult_le_compat_l. lra.
unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma lipschitz_continuous (force : R -> R -> R) (y z : R -> R) t : lipschitz_force force ->
  continuous y t -> continuous z t -> continuous (fun s => force (y s) (z s)) t.
Proof.
intros (K & HK & H) Hy Hz. apply filterlim_locally. intros d.
assert (Hd : 0 < d / (2 * (K + 1))) by (apply Rdiv_lt_0_compat; [apply cond_pos|lra]).
assert (Ly := proj1 (filterlim_locally y (y t)) Hy (mkposreal _ Hd)).
assert (Lz := proj1 (filterlim_locally z (z t)) Hz (mkposreal _ Hd)).
generalize (filter_and _ _ Ly Lz). apply filter_imp. intros s (By & Bz).
change (Rabs (y s - y t) < d / (2 * (K + 1))) in By. change (Rabs (z s - z t) < d / (2 * (K + 1))) in Bz.
change (Rabs (force (y s) (z s) - force (y t) (z t)) < d).
eapply Rle_lt_trans. apply H.
apply Rle_lt_trans with ((K + 1) * (Rabs (y s - y t) + Rabs (z s - z t))).
- apply Rmult_le_compat_r. generalize (Rabs_pos (y s - y t)) (Rabs_pos (z s - z t)). lra. lra.
- replace (pos d) with ((K + 1) * (d / (2 * (K + 1)) + d / (2 * (K + 1)))) by (field; lra).
  apply Rmult_lt_compat_l; lra.
Qed.

Inductive coordinate := of_b | of_y | of_v | of_z.
Definition coordinates := [of_b; of_y; of_v; of_z].

Lemma every_coordinate i : In i coordinates.
Proof. destruct i; simpl; auto. Qed.

Section Motion.
Variables (a1 a2 a3 eps : R).
Hypothesis Heps : 0 < eps.
Variable force : R -> R -> R -> R.
Hypothesis Hforce : lipschitz_force (force eps).

(** The right sides, with p given. *)
Definition rate (p : R -> R) (i : coordinate) (t : R) (x : coordinate -> R) : R :=
  let lambda := force eps (x of_y) (x of_z) in
  match i with
  | of_b => a2 - a3 * lambda
  | of_y => x of_v
  | of_v => x of_b + p t * lambda
  | of_z => / eps * (- x of_z - eps ^ 2 * lambda)
  end.

Lemma rate_continuous p : (forall t, continuous p t) -> forall x : coordinate -> R -> R,
  (forall i t, continuous (x i) t) ->
  forall i t, continuous (fun s => rate p i s (fun j => x j s)) t.
Proof.
intros Hp x Hx i t.
assert (HF : continuous (fun s => force eps (x of_y s) (x of_z s)) t) by (apply lipschitz_continuous; auto).
destruct i; unfold rate.
- apply (continuous_minus (fun _ => a2)). apply continuous_const.
  apply (continuous_scal_r a3 (fun s => force eps (x of_y s) (x of_z s))), HF.
- apply Hx.
- apply (continuous_plus (x of_b)). apply Hx. apply (continuous_mult p); auto.
- apply (continuous_scal_r (/ eps) (fun s => - x of_z s - eps ^ 2 * force eps (x of_y s) (x of_z s))).
  apply (continuous_minus (fun s => - x of_z s)). apply (continuous_opp (x of_z)), Hx.
  apply (continuous_scal_r (eps ^ 2) (fun s => force eps (x of_y s) (x of_z s))), HF.
Qed.

Lemma rate_lipschitz p0 t0 r : exists L, 0 <= L /\ forall s, Rabs (s - t0) <= r -> forall x x' c,
  (forall j, Rabs (x j - x' j) <= c) ->
  forall i, Rabs (rate (fun t => p0 + a1 * (t - t0)) i s x - rate (fun t => p0 + a1 * (t - t0)) i s x') <= L * c.
Proof.
destruct Hforce as (K & HK & H).
set (P := Rabs p0 + Rabs a1 * Rabs r).
assert (HP : 0 <= P).
{ unfold P. generalize (Rabs_pos p0) (Rmult_le_pos _ _ (Rabs_pos a1) (Rabs_pos r)). lra. }
assert (Hi : 0 < / eps) by (apply Rinv_0_lt_compat, Heps).
assert (A3 := Rabs_pos a3).
exists (Rabs a3 * (2 * K) + 1 + P * (2 * K) + (/ eps + eps * (2 * K))). split.
{ assert (0 <= Rabs a3 * (2 * K)) by (apply Rmult_le_pos; lra). assert (0 <= P * (2 * K)) by (apply Rmult_le_pos; lra).
  assert (0 <= eps * (2 * K)) by (apply Rmult_le_pos; lra). lra. }
intros s Hs x x' c Hc i.
assert (c0 : 0 <= c) by (eapply Rle_trans; [apply Rabs_pos|apply (Hc i)]).
set (l := force eps (x of_y) (x of_z) - force eps (x' of_y) (x' of_z)).
assert (Hl : Rabs l <= 2 * K * c).
{ eapply Rle_trans. apply H. replace (2 * K * c) with (K * (c + c)) by ring.
  apply Rmult_le_compat_l; auto. generalize (Hc of_y) (Hc of_z). lra. }
assert (K0 : 0 <= 2 * K * c) by (eapply Rle_trans; [apply Rabs_pos|exact Hl]).
assert (T1 : 0 <= Rabs a3 * (2 * K) * c) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
assert (T2 : 0 <= P * (2 * K) * c) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
assert (T3 : 0 <= / eps * c) by (apply Rmult_le_pos; lra).
assert (T4 : 0 <= eps * (2 * K) * c) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
replace ((Rabs a3 * (2 * K) + 1 + P * (2 * K) + (/ eps + eps * (2 * K))) * c)
  with (Rabs a3 * (2 * K) * c + c + P * (2 * K) * c + / eps * c + eps * (2 * K) * c) by ring.
unfold rate. destruct i.
- replace (a2 - a3 * force eps (x of_y) (x of_z) - (a2 - a3 * force eps (x' of_y) (x' of_z))) with (- a3 * l)
    by (unfold l; ring).
  rewrite Rabs_mult, Rabs_Ropp.
  assert (Rabs a3 * Rabs l <= Rabs a3 * (2 * K * c)) by (apply Rmult_le_compat_l; auto). lra.
- generalize (Hc of_v). lra.
- replace (x of_b + (p0 + a1 * (s - t0)) * force eps (x of_y) (x of_z) - (x' of_b + (p0 + a1 * (s - t0)) * force eps
    (x' of_y) (x' of_z)))
    with ((x of_b - x' of_b) + (p0 + a1 * (s - t0)) * l) by (unfold l; ring).
  eapply Rle_trans. apply Rabs_triang. rewrite (Rabs_mult _ l).
  assert (Rabs (p0 + a1 * (s - t0)) <= P).
  { eapply Rle_trans. apply Rabs_triang. apply Rplus_le_compat_l. rewrite Rabs_mult. apply Rmult_le_compat_l.
    apply Rabs_pos.
    eapply Rle_trans. exact Hs. apply Rle_abs. }
  assert (Rabs (p0 + a1 * (s - t0)) * Rabs l <= P * (2 * K * c)) by (apply Rmult_le_compat; auto using Rabs_pos).
  generalize (Hc of_b). lra.
- replace (/ eps * (- x of_z - eps ^ 2 * force eps (x of_y) (x of_z)) - / eps * (- x' of_z - eps ^ 2 * force eps
    (x' of_y) (x' of_z)))
    with (- (/ eps * (x of_z - x' of_z)) + - (eps * l)) by (unfold l; field; lra).
  eapply Rle_trans. apply Rabs_triang. rewrite !Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq (/ eps)), (Rabs_pos_eq eps) by lra.
  assert (/ eps * Rabs (x of_z - x' of_z) <= / eps * c) by (apply Rmult_le_compat_l; [lra|apply Hc]).
  assert (eps * Rabs l <= eps * (2 * K * c)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** The equations say that p is affine, and that b, y, v, z solve x' = rate. *)
Lemma z_derive (z : R -> R) t l : is_derive (fun s => eps * z s) t l -> is_derive z t (/ eps * l).
Proof.
intros D. apply (is_derive_ext (fun s => / eps * (eps * z s))).
{ intros s. change (@eq R (/ eps * (eps * z s)) (z s)). field; lra. }
apply (is_derive_scal (fun s => eps * z s)), D.
Qed.

Definition state (b y v z : R -> R) (i : coordinate) : R -> R :=
  match i with of_b => b | of_y => y | of_v => v | of_z => z end.

Lemma state_derive p b y v z t : model_at a1 a2 a3 eps force p b y v z t ->
  forall i, is_derive (state b y v z i) t (rate p i t (fun j => state b y v z j t)).
Proof. intros (_ & Db & Dy & Dv & Dz) [ | | | ]; simpl; auto. apply z_derive, Dz. Qed.

Lemma affine (p : R -> R) t0 t : (forall s, segment t0 t s -> is_derive p s a1) -> p t = p t0 + a1 * (t - t0).
Proof.
intros D. apply Rminus_diag_uniq.
destruct (Req_dec t t0) as [->|Hne]. ring.
destruct (MVT_gen p t0 t (fun _ => a1)) as (c & _ & E).
- intros s Hs. apply D. unfold segment. lra.
- intros s Hs. apply continuity_pt_filterlim, (ex_derive_continuous p s). eexists. apply D, Hs.
- lra.
Qed.

Theorem motion_exists t0 p0 b0 y0 v0 z0 : exists p b y v z,
  (forall t, model_at a1 a2 a3 eps force p b y v z t) /\
  p t0 = p0 /\ b t0 = b0 /\ y t0 = y0 /\ v t0 = v0 /\ z t0 = z0.
Proof.
set (p := fun t => p0 + a1 * (t - t0)).
assert (Dp : forall t, is_derive p t a1) by (intros t; unfold p; auto_derive; auto; ring).
assert (Cp : forall t, continuous p t) by (intros t; apply (ex_derive_continuous p); eexists; apply Dp).
destruct (solution_exists coordinate coordinates every_coordinate (rate p) (rate_continuous p Cp) t0
  (rate_lipschitz p0 t0)
  (fun i => match i with of_b => b0 | of_y => y0 | of_v => v0 | of_z => z0 end)) as (x & E & D).
exists p, (x of_b), (x of_y), (x of_v), (x of_z). split.
- intros t. refine (conj (Dp t) (conj (D of_b t) (conj (D of_y t) (conj (D of_v t) _)))).
  eapply is_derive_val. apply (is_derive_scal (x of_z) t eps), (D of_z t). unfold rate. simpl. field. lra.
- rewrite !E. unfold p. repeat split; ring.
Qed.

Theorem motion_unique p b y v z p' b' y' v' z' t0 t :
  (forall s, segment t0 t s -> model_at a1 a2 a3 eps force p b y v z s) ->
  (forall s, segment t0 t s -> model_at a1 a2 a3 eps force p' b' y' v' z' s) ->
  p t0 = p' t0 -> b t0 = b' t0 -> y t0 = y' t0 -> v t0 = v' t0 -> z t0 = z' t0 ->
  p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.
Proof.
intros H H' Ep Eb Ey Ev Ez.
assert (Sub : forall s u, segment t0 t s -> segment t0 s u -> segment t0 t u).
{ intros s u. unfold segment, Rmin, Rmax. repeat destruct Rle_dec; lra. }
assert (Ap : forall s, segment t0 t s -> p s = p t0 + a1 * (s - t0)).
{ intros s Hs. apply affine. intros u Hu. apply (H u). eauto. }
assert (Ap' : forall s, segment t0 t s -> p' s = p t0 + a1 * (s - t0)).
{ intros s Hs. rewrite Ep. apply affine. intros u Hu. apply (H' u). eauto. }
set (q := fun s => p t0 + a1 * (s - t0)).
assert (Cq : forall s, continuous q s) by (intros s; apply (ex_derive_continuous q); unfold q; auto_derive; auto).
assert (U := solution_unique coordinate coordinates every_coordinate (rate q) t0 (rate_lipschitz (p t0) t0)
  (state b y v z) (state b' y' v' z') t).
assert (U' : forall i, state b y v z i t = state b' y' v' z' i t).
{ apply U.
  - intros i s Hs. generalize (state_derive _ _ _ _ _ s (H s Hs) i). unfold rate. rewrite (Ap s Hs). auto.
  - intros i s Hs. generalize (state_derive _ _ _ _ _ s (H' s Hs) i). unfold rate. rewrite (Ap' s Hs). auto.
  - intros [ | | | ]; simpl; auto. }
assert (B : segment t0 t t) by (unfold segment; split; [apply Rmin_r|apply Rmax_r]).
refine (conj _ (conj (U' of_b) (conj (U' of_y) (conj (U' of_v) (U' of_z))))).
rewrite Ap, Ap' by exact B. reflexivity.
Qed.

End Motion.
