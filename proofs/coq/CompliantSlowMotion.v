(** * The compliant model: slow motions

    A slow motion with coefficient C, in the words of [Statement.v], is "trivial + C F_beta(t/eps)": its b is small
    enough at t -> -oo for [contact_unique], and the limit of the quotient picks C. The theorems about [sol_...] so
    become theorems about every slow motion. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow CompliantMechanism CompliantCone CompliantUnique CompliantContact CompliantDependence CompliantMotion
  CompliantForward CompliantZeros CompliantCases CompliantOpen.
Open Scope R_scope.

Section SlowMotion.
Variables (a1 a2 a3 eps : R).
Hypothesis Hpar : parameters a1 a3 eps.

Lemma par1 : a1 < 0. Proof. apply Hpar. Qed.
Lemma par3 : a3 < 0. Proof. apply Hpar. Qed.
Lemma par_eps : 0 < eps. Proof. apply Hpar. Qed.
Lemma par_beta : not_nat (a3 / a1). Proof. apply Hpar. Qed.
Let H1 := par1.
Let H3 := par3.
Let He := par_eps.
Let Hb := par_beta.

Lemma sol_limit C : is_lim (fun x => (sol_b a1 a2 a3 eps C (- x) - a2 / (a1 - a3) * a1 * - x) / Rpower (x / eps)
  (a3 / a1)) p_infty C.
Proof.
assert (HF := Fe_asymptotics (- a1 * eps) (He' a1 eps H1 He) (a3 / a1) Hb).
apply (is_lim_ext (fun x => C * (Fe (- a1 * eps) (a3 / a1) (- (x / eps)) / Rpower (x / eps) (a3 / a1)))).
{ intros x. unfold sol_b, rec_b, hb. simpl Derive_n. simpl pow.
  replace (- x / eps) with (- (x / eps)) by (field; lra). unfold Rdiv. rewrite Rinv_1. ring. }
replace (Finite C) with (Finite (C * 1)) by (f_equal; ring).
apply (is_lim_scal_l _ C p_infty 1).
apply is_lim_spec. apply is_lim_spec in HF. intros e. destruct (HF e) as [M HM].
exists (eps * M). intros x Hx. apply HM.
apply Rmult_lt_reg_l with eps; auto. replace (eps * (x / eps)) with x by (field; lra). exact Hx.
Qed.

Theorem slow_motion_sol C : slow_motion a1 a2 a3 eps C (sol_p a1) (sol_b a1 a2 a3 eps C) (sol_y a1 a2 a3 eps C)
  (sol_v a1 a3 eps C) (sol_z a1 a2 a3 eps C).
Proof.
split; [reflexivity|split]. apply sol_contact; auto. apply sol_limit.
Qed.

(** b is small at -oo *)
Lemma slow_motion_small C p b y v z : slow_motion a1 a2 a3 eps C p b y v z -> slow_at_left eps b.
Proof.
intros (_ & _ & HL).
destruct (Rpower_le_exp (a3 / a1)) as (A & HA & HP).
apply is_lim_spec in HL. destruct (HL (mkposreal 1 Rlt_0_1)) as [M HM]. simpl in HM.
set (k := a2 / (a1 - a3) * a1) in *. set (w := a3 / a1) in *.
exists (((Rabs C + 1) * (Rpower 2 w * A) + Rabs k * (16 * eps))), (- (Rmax (2 * eps) (M + 1))).
intros t Ht.
assert (M1 := Rmax_l (2 * eps) (M + 1)). assert (M2 := Rmax_r (2 * eps) (M + 1)).
specialize (HM (- t) ltac:(lra)). rewrite Ropp_involutive in HM.
set (x := - t / (2 * eps)).
assert (Hx : 1 <= x).
{ unfold x. apply Rmult_le_reg_r with (2 * eps). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
specialize (HP x Hx). replace (x / 8) with (- t / (16 * eps)) in HP by (unfold x; field; lra).
assert (EX : Rpower (- t / eps) w = Rpower 2 w * Rpower x w).
{ rewrite Rpower_mult_distr by lra. f_equal. unfold x. field. lra. }
set (E := exp (- t / (16 * eps))) in *.
assert (HE : 1 + - t / (16 * eps) <= E) by apply exp_ineq1_le.
set (X := Rpower (- t / eps) w) in *. assert (HX : 0 < X) by apply exp_pos.
set (q := (b t - k * t) / X) in *.
assert (Hq : Rabs q <= Rabs C + 1).
{ replace q with (C + (q - C)) by ring. eapply Rle_trans. apply Rabs_triang. lra. }
assert (Eb : b t = q * X + k * t) by (unfold q; field; lra).
rewrite Eb. eapply Rle_trans. apply Rabs_triang. rewrite !Rabs_mult, (Rabs_pos_eq X), (Rabs_left1 t) by lra.
assert (HX2 : X <= Rpower 2 w * (A * E)).
{ rewrite EX. apply Rmult_le_compat_l; auto. apply Rlt_le, exp_pos. }
assert (Ht2 : - t <= 16 * eps * E).
{ replace (- t) with (16 * eps * (- t / (16 * eps))) by (field; lra). apply Rmult_le_compat_l; lra. }
assert (Rabs q * X <= (Rabs C + 1) * (Rpower 2 w * (A * E))).
{ apply Rmult_le_compat; auto using Rabs_pos. lra. }
assert (Rabs k * - t <= Rabs k * (16 * eps * E)) by (apply Rmult_le_compat_l; auto using Rabs_pos).
lra.
Qed.

(** A slow motion with coefficient C is [sol_...] with this C. *)
Theorem slow_motion_is_sol C p b y v z : slow_motion a1 a2 a3 eps C p b y v z ->
  forall t, p t = sol_p a1 t /\ b t = sol_b a1 a2 a3 eps C t /\ y t = sol_y a1 a2 a3 eps C t /\
    v t = sol_v a1 a3 eps C t /\ z t = sol_z a1 a2 a3 eps C t /\ linear_force eps (y t) (z t) = sol_l a1 a2 a3 eps C t.
Proof.
intros HS. assert (Gb := slow_motion_small _ _ _ _ _ _ HS). destruct HS as (Hp & Hm & HL).
destruct (contact_unique a1 a2 a3 eps H1 H3 He Hb p_infty p b y v z (fun t _ => Hp t) (fun t _ => Hm t) Gb)
  as (C' & HC).
assert (EC : C' = C).
{ assert (HL' := sol_limit C').
  apply (is_lim_ext _ (fun x => (b (- x) - a2 / (a1 - a3) * a1 * - x) / Rpower (x / eps) (a3 / a1))) in HL'.
  2: { intros x. destruct (HC (- x) I) as (_ & -> & _). reflexivity. }
  apply is_lim_unique in HL. apply is_lim_unique in HL'. congruence. }
subst C'. intros t. exact (HC t I).
Qed.

Theorem slow_motion_unique C p b y v z p' b' y' v' z' :
  slow_motion a1 a2 a3 eps C p b y v z -> slow_motion a1 a2 a3 eps C p' b' y' v' z' ->
  forall t, p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.
Proof.
intros S S' t.
destruct (slow_motion_is_sol _ _ _ _ _ _ S t) as (-> & -> & -> & -> & -> & _).
destruct (slow_motion_is_sol _ _ _ _ _ _ S' t) as (-> & -> & -> & -> & -> & _).
repeat split.
Qed.

Theorem slow_motions_are_all p b y v z : (forall t, p t = a1 * t) ->
  (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) ->
  (slow_at_left eps b <-> exists C, slow_motion a1 a2 a3 eps C p b y v z).
Proof.
intros Hp Hm. split; [intros Gb|intros (C & HS); exact (slow_motion_small C p b y v z HS)].
destruct (contact_unique a1 a2 a3 eps H1 H3 He Hb p_infty p b y v z (fun t _ => Hp t) (fun t _ => Hm t) Gb) as (C & HC).
exists C. refine (conj Hp (conj Hm _)).
apply (is_lim_ext (fun x => (sol_b a1 a2 a3 eps C (- x) - a2 / (a1 - a3) * a1 * - x) / Rpower (x / eps) (a3 / a1))).
{ intros x. destruct (HC (- x) I) as (_ & -> & _). reflexivity. }
apply sol_limit.
Qed.

Section Given.
Variables (C : R) (P B Y V Z : R -> R).
Hypothesis HS : slow_motion a1 a2 a3 eps C P B Y V Z.

Lemma slow_force t : linear_force eps (Y t) (Z t) = sol_l a1 a2 a3 eps C t.
Proof. apply (slow_motion_is_sol C P B Y V Z HS t). Qed.

Lemma slow_contact t : 0 < sol_l a1 a2 a3 eps C t <-> Y t < Z t.
Proof. rewrite <- slow_force. apply linear_force_pos, He. Qed.

Lemma slow_apart t : sol_l a1 a2 a3 eps C t < 0 <-> Z t < Y t.
Proof.
rewrite <- slow_force. unfold linear_force.
assert (Hp : 0 < / eps ^ 2) by (apply Rinv_0_lt_compat, pow_lt, He). unfold Rdiv. split; intros H; nra.
Qed.

Lemma slow_touch t : sol_l a1 a2 a3 eps C t = 0 -> Y t = Z t.
Proof.
intros E. assert (A := slow_contact t). assert (A' := slow_apart t). rewrite E in A, A'.
destruct (Rtotal_order (Y t) (Z t)) as [H|[H|H]]; auto.
- apply A in H. lra.
- apply A' in H. lra.
Qed.

Theorem side_rule :
  (0 < C * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t -> M <= linear_force eps (Y t) (Z t)) /\
  (C * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> linear_force eps (Y t) (Z t) <= M).
Proof.
split; intros HC M.
- destruct (side_rule_up a1 a2 a3 eps C H1 H3 He Hb HC M) as (T & HT). exists T. intros t Ht. rewrite slow_force. auto.
- destruct (side_rule_down a1 a2 a3 eps C H1 H3 He Hb HC M) as (T & HT). exists T. intros t Ht. rewrite slow_force.
  auto.
Qed.

Theorem IWC_compliant t0 p b y v z : IWC_side (a3 / a1) C ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 -> y t0 <= z t0 ->
  (forall t, t0 < t -> y t < z t) /\
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros HC Hm Ep Eb Ey Ev Ez Hyz.
destruct (slow_motion_is_sol C P B Y V Z HS t0) as (F1 & F2 & F3 & F4 & F5 & _).
apply (IWC_forward a1 a2 a3 eps H1 H3 He Hb C t0 p b y v z HC Hm); congruence || auto.
Qed.

(** The motion of the mechanism from such a state: it exists, and is the slow motion itself from t0 on. *)
Theorem IWC_motion t0 : IWC_side (a3 / a1) C -> Y t0 <= Z t0 -> exists p b y v z,
  (forall t, model_at a1 a2 a3 eps contact_force p b y v z t) /\
  forall t, t0 <= t -> p t = P t /\ b t = B t /\ y t = Y t /\ v t = V t /\ z t = Z t.
Proof.
intros HC Hyz.
assert (HM : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force P B Y V Z t).
{ destruct (IWC_model a1 a2 a3 eps C H1 H3 He Hb HC) as (_ & _ & Hc).
  assert (S0 : 0 <= sol_l a1 a2 a3 eps C t0).
  { apply Rnot_lt_le. intros Hl. apply slow_apart in Hl. lra. }
  destruct (Hc t0 S0) as (Hpos & _).
  intros t Ht. destruct HS as (_ & Hm & _). specialize (Hm t). unfold model_at in *.
  rewrite contact_force_in_contact; auto. rewrite slow_force.
  destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|<-]; [apply Rlt_le, Hpos, Hl|exact S0]. }
destruct (CompliantMotion.motion_exists a1 a2 a3 eps He contact_force (contact_lipschitz eps He) t0 (P t0) (B t0) (Y t0)
  (V t0) (Z t0))
  as (p & b & y & v & z & Hm & Ep & Eb & Ey & Ev & Ez).
exists p, b, y, v, z. split; auto. intros t Ht.
apply (forward_unique a1 a2 a3 eps He p b y v z P B Y V Z t0 t); auto; try lra. intros s Hs. apply HM. lra.
Qed.

Theorem lift_off_compliant t0 : IWC_side (a3 / a1) (- C) -> Y t0 < Z t0 ->
  (forall s t, s < t -> linear_force eps (Y t) (Z t) < linear_force eps (Y s) (Z s)) /\
  exists t1, t0 < t1 /\ Y t1 = Z t1 /\ (forall t, t < t1 -> Y t < Z t) /\ (forall t, t1 < t -> Z t < Y t).
Proof.
intros HC Hyz.
assert (HC' : (a3 / a1 < 1 /\ 0 < C) \/ (1 < a3 / a1 < 2 /\ C < 0)).
{ destruct HC as [[A D]|[A D]]; [left|right]; split; auto; lra. }
destruct (lift_off_model a1 a2 a3 eps C H1 H3 He Hb HC') as (Hdec & Hlift). split.
- intros s t Hst. rewrite !slow_force. auto.
- destruct (Hlift t0) as (t1 & G0 & G1 & G2 & G3). { apply slow_contact, Hyz. }
  exists t1. refine (conj G0 (conj (slow_touch t1 G1) (conj _ _))).
  + intros t Ht. apply slow_contact, G2, Ht.
  + intros t Ht. apply slow_apart, G3, Ht.
Qed.

Theorem slow_case_I : a3 / a1 < 1 -> a2 < 0 -> C < 0 ->
  exists t0, (forall t, t < t0 -> Z t < Y t) /\ (forall t, t0 < t -> Y t < Z t) /\
    forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force P B Y V Z t.
Proof.
intros Hlt H2 HC.
destruct (case_I a1 a2 a3 eps C H1 H3 He Hb Hlt H2 HC) as (t0 & E0 & N & Pos & _).
exists t0. refine (conj _ (conj _ _)).
- intros t Ht. apply slow_apart, N, Ht.
- intros t Ht. apply slow_contact, Pos, Ht.
- intros t Ht. destruct HS as (_ & Hm & _). specialize (Hm t).
  assert (E : contact_force eps (Y t) (Z t) = linear_force eps (Y t) (Z t)).
  { apply contact_force_in_contact; auto. rewrite slow_force.
    destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|<-]; [apply Rlt_le, Pos, Hl|lra]. }
  unfold model_at in *. rewrite E. exact Hm.
Qed.

Theorem force_deviation : a3 / a1 < 1 -> C < 0 ->
  let deviation t := linear_force eps (Y t) (Z t) - a2 / (a3 - a1) in
  (forall t, 0 < deviation t) /\ (forall s t, s < t -> deviation s < deviation t) /\
  (forall d, 0 < d -> exists T, forall t, t <= T -> deviation t < d) /\
  (forall M, exists T, forall t, T <= t -> M <= deviation t).
Proof.
intros Hlt HC deviation.
destruct (IWC_model a1 a2 a3 eps C H1 H3 He Hb (or_introl (conj Hlt HC))) as (Hinc & Hinf & _).
set (mean := a2 / (a3 - a1)) in *.
assert (E : forall t, deviation t = sol_l a1 a2 a3 eps C t - mean) by (intros t; unfold deviation; rewrite slow_force;
  reflexivity).
assert (Inc : forall s t, s < t -> deviation s < deviation t).
{ intros s t Hst. rewrite !E. assert (A := Hinc s t Hst). lra. }
refine (conj _ (conj Inc (conj _ _))).
- intros t. apply Rnot_le_lt. intros Hn.
  assert (A := Inc (t - 1) t ltac:(lra)).
  destruct (force_left a1 a2 a3 eps C H1 H3 He Hb Hlt (- deviation (t - 1)) ltac:(lra)) as (T & HT).
  assert (M1 := Rmin_l T (t - 2)). assert (M2 := Rmin_r T (t - 2)).
  specialize (HT (Rmin T (t - 2)) M1). fold mean in HT. rewrite <- E in HT.
  assert (A' := Inc (Rmin T (t - 2)) (t - 1) ltac:(lra)).
  apply Rabs_def2 in HT. lra.
- intros d Hd. destruct (force_left a1 a2 a3 eps C H1 H3 He Hb Hlt d Hd) as (T & HT).
  exists T. intros t Ht. specialize (HT t Ht). fold mean in HT. rewrite <- E in HT. apply Rabs_def2 in HT. lra.
- intros M. destruct (Hinf (M + mean)) as (T & HT). exists T. intros t Ht. rewrite E. specialize (HT t Ht). lra.
Qed.

(** The derivatives of the force. *)
Lemma slow_force_derive n t : Derive_n (fun t => linear_force eps (Y t) (Z t)) n t = dl a1 a2 a3 eps C n t.
Proof.
rewrite (Derive_n_ext _ (dl a1 a2 a3 eps C 0)) by (intros; apply slow_force).
revert t. induction n as [|n IH]; intros t; [reflexivity|].
change (Derive (Derive_n (dl a1 a2 a3 eps C 0) n) t = dl a1 a2 a3 eps C (S n) t).
rewrite (Derive_ext _ (dl a1 a2 a3 eps C n)) by exact IH. apply is_derive_unique, dl_derive; auto.
Qed.

Theorem contact_tail n t0 : a3 / a1 < INR (n + 2) -> 0 < C * Gamma (- (a3 / a1)) ->
  (forall k, (k <= n)%nat -> 0 <= Derive_n (fun t => linear_force eps (Y t) (Z t)) k t0) ->
  forall t, t0 < t -> Y t < Z t.
Proof.
intros Hn HC H0 t Ht. apply slow_contact. replace (n + 2)%nat with (S (S n)) in Hn by lia.
apply (tail_IWC a1 a2 a3 eps C H1 H3 He Hb n t0 Hn HC); auto.
intros k Hk. rewrite <- slow_force_derive. auto.
Qed.

Theorem slow_force_zeros n l : a3 / a1 < INR (n + 2) -> C <> 0 -> StronglySorted Rlt l ->
  (forall t, In t l -> Y t = Z t) -> (length l <= n + 1)%nat.
Proof.
intros Hn HC HS' H0. replace (n + 2)%nat with (S (S n)) in Hn by lia. replace (n + 1)%nat with (S n) by lia.
apply (force_zeros a1 a2 a3 eps C n l); auto.
intros t Ht. rewrite <- slow_force, (H0 t Ht). unfold linear_force, Rdiv. ring.
Qed.

Theorem slow_in_open_set t : a1 < a3 -> C < 0 -> Y t < Z t ->
  0 < force_excess a1 a2 a3 eps (Y t) (Z t) /\ 0 < force_excess1 eps (Y t) (V t) (Z t) /\
  0 < force_excess2 eps (P t) (B t) (Y t) (V t) (Z t) /\ 0 < force_excess3 a1 a2 a3 eps (P t) (B t) (Y t) (V t) (Z t).
Proof.
intros H13 HC. destruct (slow_motion_is_sol C P B Y V Z HS t) as (-> & E2 & E3 & E4 & E5 & _).
rewrite E2, E3, E4, E5. intros Hyz.
destruct (slow_in_open a1 a2 a3 eps C t H1 H13 H3 He HC Hyz) as (_ & D0 & D1 & D2 & D3).
exact (conj D0 (conj D1 (conj D2 D3))).
Qed.

End Given.
End SlowMotion.
