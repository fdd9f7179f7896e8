(** * The compliant model: contacts that last for ever

    In contact let lambda be the force, W = - v/eps, G = - (b + p lambda), S = W + G, D = eps lambda', q = - p, A = -
    eps a2, kappa = eps (a1 - a3), and ' the derivative times eps. Then lambda' = D, D' = - 2 D + S, W' = G, G' = q D -
    kappa lambda + A, q' = - eps a1. For suitable combinations the off-diagonal entries are >= 0, so that they stay >= 0
    ([NonnegativeOrthant.v]). The motion with the linear law of force then has a force >= 0, hence is that of the
    mechanism. [below_one]: beta <= 1; [cone_kept], [cone_grows]: beta > 1. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight Calculus CompliantDependence InitialValueProblem
  CompliantMotion CompliantMechanism CompliantForward
  NonnegativeOrthant.
Import ListNotations.
Open Scope R_scope.

(** x increases, x' >= (u - 2 x)/eps, u -> oo: x -> oo. *)
Lemma follows_to_infinity (eps t0 : R) (x u : R -> R) : 0 < eps ->
  (forall t, t0 <= t -> is_derive x t ((u t - 2 * x t) / eps)) -> (forall t, t0 <= t -> 2 * x t <= u t) ->
  (forall M, exists T, forall t, T <= t -> M <= u t) -> forall M, exists T, forall t, T <= t -> M <= x t.
Proof.
intros He D Hx Hu N.
assert (Hi : 0 < / eps) by (apply Rinv_0_lt_compat, He).
assert (Mono : forall s t, t0 <= s <= t -> x s <= x t).
{ intros s t Hst. apply Ropp_le_cancel.
  apply (decr_of_derive (fun t => - x t) (fun t => - ((u t - 2 * x t) / eps)) s t (proj2 Hst)).
  - intros r Hr. apply (is_derive_opp x), D. lra.
  - intros r Hr. specialize (Hx r ltac:(lra)). assert (0 <= (u r - 2 * x r) / eps) by (apply Rmult_le_pos; lra). lra. }
destruct (Hu (2 * N + 2)) as (T & HT).
set (a := Rmax T t0). assert (A1 : T <= a) by apply Rmax_l. assert (A2 : t0 <= a) by apply Rmax_r.
set (k := eps * Rmax 0 (N - x a)). assert (Hk : 0 <= k) by (apply Rmult_le_pos; [lra|apply Rmax_l]).
exists (a + k). intros t Ht. apply Rnot_lt_le. intros Hn.
assert (Hak : x (a + k) < N) by (generalize (Mono (a + k) t ltac:(lra)); lra).
destruct (Rle_lt_or_eq_dec _ _ Hk) as [Hk0|E].
- destruct (mvt_open x (fun t => (u t - 2 * x t) / eps) a (a + k) ltac:(lra)) as (c & Hc & Em).
  { intros s Hs. apply D. lra. }
  assert (xc : x c <= x (a + k)) by (apply Mono; lra). specialize (HT c ltac:(lra)).
  assert (B : 2 * / eps <= (u c - 2 * x c) / eps) by (apply Rmult_le_compat_r; lra).
  apply (Rmult_le_compat_r k) in B; [|lra].
  replace (2 * / eps * k) with (2 * Rmax 0 (N - x a)) in B by (unfold k; field; lra).
  replace (a + k - a) with k in Em by ring. generalize (Rmax_r 0 (N - x a)) (Rmax_l 0 (N - x a)). lra.
- rewrite <- E, Rplus_0_r in Hak. assert (Rmax 0 (N - x a) = 0).
  { unfold k in E. symmetry in E. apply Rmult_integral in E. destruct E; lra. }
  generalize (Rmax_r 0 (N - x a)). lra.
Qed.

Section Linear.
Variables (a1 a2 a3 eps : R).
Hypothesis Heps : 0 < eps.
Variables P B Y V Z : R -> R.
Hypothesis Hlin : forall t, model_at a1 a2 a3 eps linear_force P B Y V Z t.

Definition L (t : R) : R := linear_force eps (Y t) (Z t).
Definition D (t : R) : R := force_rate eps (Y t) (V t) (Z t).
Definition W (t : R) : R := - V t / eps.
Definition G (t : R) : R := deceleration eps (P t) (B t) (Y t) (Z t).
Definition S (t : R) : R := W t + G t.
Definition q (t : R) : R := - P t.
Definition A : R := - eps * a2.
Definition kappa : R := eps * (a1 - a3).
Definition G' (t : R) : R := q t * D t - kappa * L t + A.

Lemma Z_derive t : is_derive Z t (/ eps * (- Z t - eps ^ 2 * L t)).
Proof. apply (z_derive eps Heps), (Hlin t). Qed.

Lemma L_derive t : is_derive L t (D t / eps).
Proof.
destruct (Hlin t) as (_ & _ & Dy & _ & _).
apply (is_derive_ext (fun t => / eps ^ 2 * (Z t - Y t))).
{ intros s. unfold L, linear_force, Rdiv. match goal with |- ?x = ?y => change (@eq R x y) end. ring. }
eapply is_derive_val.
- apply (is_derive_scal (fun t => Z t - Y t)). apply (is_derive_minus Z Y). apply Z_derive. exact Dy.
- unfold minus, plus, opp; simpl. unfold D, force_rate, L, linear_force. field. lra.
Qed.

Lemma W_derive t : is_derive W t (G t / eps).
Proof.
destruct (Hlin t) as (_ & _ & _ & Dv & _).
apply (is_derive_ext (fun t => - / eps * V t)).
{ intros s. unfold W, Rdiv. match goal with |- ?x = ?y => change (@eq R x y) end. ring. }
eapply is_derive_val. apply (is_derive_scal V), Dv. unfold G, deceleration. field. lra.
Qed.

Lemma D_derive t : is_derive D t ((- 2 * D t + S t) / eps).
Proof.
destruct (Hlin t) as (_ & _ & Dy & Dv & _).
apply (is_derive_ext (fun t => / eps ^ 2 * (Y t - 2 * Z t - eps * V t))).
{ intros s. unfold D, force_rate, Rdiv. match goal with |- ?x = ?y => change (@eq R x y) end. ring. }
eapply is_derive_val.
- apply (is_derive_scal (fun t => Y t - 2 * Z t - eps * V t)).
  apply (is_derive_minus (fun t => Y t - 2 * Z t) (fun t => eps * V t)).
  apply (is_derive_minus Y (fun t => 2 * Z t)). exact Dy. apply (is_derive_scal Z), Z_derive.
  apply (is_derive_scal V), Dv.
- unfold minus, plus, opp; simpl. unfold D, S, W, G, force_rate, deceleration, L, linear_force. field. lra.
Qed.

Lemma q_derive t : is_derive q t (- a1).
Proof. apply (is_derive_opp P), (Hlin t). Qed.

Lemma G_derive t : is_derive G t (G' t / eps).
Proof.
destruct (Hlin t) as (Dp & Db & _ & _ & _).
eapply is_derive_val.
- apply (is_derive_opp (fun t => B t + P t * L t)). apply (is_derive_plus B (fun t => P t * L t)). exact Db.
  apply (is_derive_mult_R P L). exact Dp. apply L_derive.
- unfold minus, plus, opp; simpl. unfold G', q, kappa, A. fold (L t). field. lra.
Qed.

Lemma S_derive t : is_derive S t ((G t + G' t) / eps).
Proof.
eapply is_derive_val. apply (is_derive_plus W G). apply W_derive. apply G_derive. unfold plus; simpl. field. lra.
Qed.

Hypothesis Ha1 : a1 < 0.

Lemma q_affine s t : q t = q s + - a1 * (t - s).
Proof. apply (affine (- a1)). intros. apply q_derive. Qed.

(** D stays > 0 while S >= 0. *)
Lemma D_positive t0 : (forall t, t0 <= t -> 0 <= S t) -> 0 < D t0 -> forall t, t0 <= t -> 0 < D t.
Proof.
intros HS H0 t Ht.
assert (M : - (D t * exp (2 * t / eps)) <= - (D t0 * exp (2 * t0 / eps))).
{ apply (decr_of_derive (fun t => - (D t * exp (2 * t / eps))) (fun t => - (S t * exp (2 * t / eps) / eps)) t0 t Ht).
  - intros s Hs. apply (is_derive_opp (fun t => D t * exp (2 * t / eps))). eapply is_derive_val.
    + apply (is_derive_mult_R D (fun s => exp (2 * s / eps)) s _ (2 / eps * exp (2 * s / eps)) (D_derive s)).
      auto_derive; auto. unfold Rdiv; ring.
    + field. lra.
  - intros s Hs. assert (0 <= S s * exp (2 * s / eps) / eps); [|lra].
    apply Rmult_le_pos. apply Rmult_le_pos. apply HS; lra. apply Rlt_le, exp_pos.
    apply Rlt_le, Rinv_0_lt_compat, Heps. }
assert (E0 := exp_pos (2 * t0 / eps)). assert (E1 := exp_pos (2 * t / eps)).
assert (0 < D t0 * exp (2 * t0 / eps)) by (apply Rmult_lt_0_compat; auto).
apply Rmult_lt_reg_r with (exp (2 * t / eps)); auto. lra.
Qed.

(** What makes the mechanism's motion through the same state one of contact for ever. *)
Definition grows_from (t0 : R) : Prop :=
  (forall t, t0 <= t -> 0 <= L t) /\ (forall t, t0 <= t -> 0 < D t) /\ (forall M, exists T, forall t, T <= t ->
    M <= L t).

Theorem grows t0 p b y v z : mechanism_from a1 a2 a3 eps t0 p b y v z ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 -> grows_from t0 ->
    contact_for_ever eps t0 y z.
Proof.
intros Hm Ep Eb Ey Ev Ez (HL & HD & Hinf).
assert (Hl : forall t, t0 <= t -> contact_force eps (Y t) (Z t) = L t) by (intros t Ht; apply contact_force_in_contact;
  auto; apply HL, Ht).
assert (HM : forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force P B Y V Z t).
{ intros t Ht. assert (M := Hlin t). unfold model_at in *. rewrite (Hl t Ht). exact M. }
assert (U : forall t, t0 <= t -> y t = Y t /\ z t = Z t).
{ intros t Ht. destruct (forward_unique a1 a2 a3 eps Heps p b y v z P B Y V Z t0 t (fun s Hs => Hm s (proj1 Hs))
    (fun s Hs => HM s (proj1 Hs))
    Ep Eb Ey Ev Ez t ltac:(lra)) as (_ & _ & E1 & _ & E2). auto. }
assert (Hc : forall t, t0 < t -> y t < z t).
{ intros t Ht. destruct (U t ltac:(lra)) as (-> & ->). apply (linear_force_pos eps); auto. change (0 < L t).
  destruct (mvt_open L (fun t => D t / eps) t0 t Ht (fun s _ => L_derive s)) as (c & Hc & E).
  specialize (HL t0 (Rle_refl _)). specialize (HD c ltac:(lra)).
  assert (0 < D c / eps * (t - t0)); [|lra]. apply Rmult_lt_0_compat. apply Rdiv_lt_0_compat; auto. lra. }
assert (Hf : forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)).
{ intros M. destruct (Hinf M) as (T & HT). exists (Rmax T t0). intros t Ht.
  assert (M1 := Rmax_l T t0). assert (M2 := Rmax_r T t0). destruct (U t ltac:(lra)) as (-> & ->). rewrite Hl by lra.
  apply HT. lra. }
refine (conj Hc (conj Hf _)).
apply (penetrate eps t0 y z (fun t => contact_force eps (y t) (z t)) Heps); auto. intros t Ht. apply (Hm t Ht).
Qed.

(** S -> oo: lambda -> oo, since (D + 2 lambda)' = S. *)
Lemma force_to_infinity t0 : (forall t, t0 <= t -> 0 <= D t) -> (exists c T, 0 < c /\ forall t, T <= t -> c <= S t) ->
  forall M, exists T, forall t, T <= t -> M <= L t.
Proof.
intros HD (c & T & Hc & HS).
apply (follows_to_infinity eps t0 L (fun t => D t + 2 * L t) Heps).
- intros t _. eapply is_derive_val. apply L_derive. f_equal. ring.
- intros t Ht. specialize (HD t Ht). lra.
- assert (G0 : forall M, exists T', T <= T' /\ forall t, T' <= t -> M <= D t + 2 * L t).
  { apply (grow (fun t => D t + 2 * L t) (fun t => S t / eps) (c / eps) T).
    - intros t. eapply is_derive_val. apply (is_derive_plus D (fun t => 2 * L t)). apply D_derive.
      apply (is_derive_scal L), L_derive.
      unfold plus; simpl. field. lra.
    - apply Rdiv_lt_0_compat; auto.
    - intros t Ht. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, Heps. auto. }
  intros M. destruct (G0 M) as (T' & _ & H). exists T'. exact H.
Qed.

(** ** beta <= 1 (Theorem F2) *)
Theorem below_one t0 : a1 <= a3 -> a2 <= 0 -> 0 <= q t0 -> 0 <= L t0 -> 0 <= W t0 -> 0 <= G t0 -> 0 < D t0 ->
  grows_from t0.
Proof.
intros H13 H2 Hq HL HW HG HD.
assert (Hkappa : kappa <= 0).
{ unfold kappa. assert (0 <= eps * (a3 - a1)) by (apply Rmult_le_pos; lra). lra. }
assert (HA : 0 <= A) by (unfold A; assert (0 <= eps * - a2) by (apply Rmult_le_pos; lra); lra).
assert (Hqt : forall t, t0 <= t -> q t0 <= q t).
{ intros t Ht. rewrite (q_affine t0 t). assert (0 <= - a1 * (t - t0)) by (apply Rmult_le_pos; lra). lra. }
set (comps := [(L, D); (D, fun t => - 2 * D t + S t); (W, G); (G, G')] : list component).
assert (O : forall t x x', t0 <= t -> In (x, x') comps -> 0 <= x t).
{ intros t x x' Ht Hx. apply (orthant_kept eps (1 + q t + - kappa) t0 t comps Heps) with (x' := x'); auto; try lra.
  - intros f f' s Hf _. unfold comps in Hf. simpl in Hf.
    destruct Hf as [E|[E|[E|[E|[]]]]]; injection E as <- <-;
      [apply L_derive|apply D_derive|apply W_derive|apply G_derive].
  - intros f f' Hf. unfold comps in Hf. simpl in Hf. destruct Hf as [E|[E|[E|[E|[]]]]]; injection E as <- _; lra.
  - intros s m Hs Hm Hall.
    assert (ML : - m <= L s) by (apply (Hall L D); simpl; auto).
    assert (MD : - m <= D s) by (apply (Hall D (fun t => - 2 * D t + S t)); simpl; auto).
    assert (MW : - m <= W s) by (apply (Hall W G); simpl; auto).
    assert (MG : - m <= G s) by (apply (Hall G G'); simpl; auto).
    assert (Q0 := Hqt s (proj1 Hs)). assert (Qs : q s <= q t).
    { rewrite (q_affine s t). assert (0 <= - a1 * (t - s)) by (apply Rmult_le_pos; lra). lra. }
    assert (K1 : 0 <= q t * m) by (apply Rmult_le_pos; lra).
    assert (K2 : 0 <= - kappa * m) by (apply Rmult_le_pos; lra).
    intros f f' Hf Ef. simpl in Hf.
    destruct Hf as [E|[E|[E|[E|[]]]]]; injection E as <- <-; unfold S, G'; try lra.
    assert (0 <= q s * (D s + m)) by (apply Rmult_le_pos; lra).
    assert (0 <= - kappa * (L s + m)) by (apply Rmult_le_pos; lra).
    assert (0 <= (q t - q s) * m) by (apply Rmult_le_pos; lra). lra. }
assert (OL : forall t, t0 <= t -> 0 <= L t) by (intros t Ht; apply (O t L D Ht); simpl; auto).
assert (OD : forall t, t0 <= t -> 0 <= D t) by (intros t Ht; apply (O t D (fun t => - 2 * D t + S t) Ht); simpl; auto).
assert (OW : forall t, t0 <= t -> 0 <= W t) by (intros t Ht; apply (O t W G Ht); simpl; auto).
assert (OG : forall t, t0 <= t -> 0 <= G t) by (intros t Ht; apply (O t G G' Ht); simpl; auto 6).
assert (Pos : forall t, t0 <= t -> 0 < D t).
{ apply D_positive; auto. intros t Ht. unfold S. generalize (OW t Ht) (OG t Ht). lra. }
refine (conj OL (conj Pos _)).
apply (force_to_infinity t0 OD).
assert (Gup : forall t, t0 <= t -> 0 <= G' t).
{ intros t Ht. unfold G'. assert (0 <= q t * D t) by (apply Rmult_le_pos; auto; generalize (Hqt t Ht); lra).
  assert (0 <= - kappa * L t) by (apply Rmult_le_pos; auto; lra). lra. }
exists (G (t0 + 1)), (t0 + 1). split.
- destruct (mvt_open G (fun t => G' t / eps) t0 (t0 + 1) ltac:(lra) (fun s _ => G_derive s)) as (c & Hc & E).
  assert (0 < G' c / eps * (t0 + 1 - t0)); [|lra]. apply Rmult_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; auto.
  unfold G'. assert (0 < q c * D c).
  { apply Rmult_lt_0_compat. rewrite (q_affine t0 c). assert (0 < - a1 * (c - t0)) by (apply Rmult_lt_0_compat; lra).
    lra. apply Pos; lra. }
  assert (0 <= - kappa * L c) by (apply Rmult_le_pos; [lra|apply OL; lra]). lra.
- intros t Ht. assert (- G t <= - G (t0 + 1)).
  { apply (decr_of_derive (fun t => - G t) (fun t => - (G' t / eps)) (t0 + 1) t Ht).
    + intros s _. apply (is_derive_opp G), G_derive.
    + intros s Hs. assert (0 <= G' s / eps); [|lra]. apply Rmult_le_pos. apply Gup; lra.
      apply Rlt_le, Rinv_0_lt_compat, Heps. }
  unfold S. generalize (OW t ltac:(lra)). lra.
Qed.

End Linear.

(** It is enough to look at the motion with the linear law through the same state. *)
Theorem contact_lasts (a1 a2 a3 eps t0 : R) (p b y v z : R -> R) : 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z ->
  (forall P B Y V Z, (forall t, model_at a1 a2 a3 eps linear_force P B Y V Z t) ->
     P t0 = p t0 -> B t0 = b t0 -> Y t0 = y t0 -> V t0 = v t0 -> Z t0 = z t0 -> grows_from eps Y V Z t0) ->
  contact_for_ever eps t0 y z.
Proof.
intros He Hm H.
destruct (motion_exists a1 a2 a3 eps He linear_force (linear_lipschitz eps He) t0 (p t0) (b t0) (y t0) (v t0) (z t0))
  as (P & B & Y & V & Z & Hlin & HP & HB & HY & HV & HZ).
apply (grows a1 a2 a3 eps He P B Y V Z Hlin t0 p b y v z); auto. apply (H P B Y V Z); auto.
Qed.
