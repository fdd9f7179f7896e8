(** * The compliant model: the slow solution is unique

    A solution of the deviation equation that grows less than e^(|T|/16) as T -> -oo is a multiple of F_beta; if
    f(-x)/x^beta -> 1 it is F_beta. (For Theta this leading behaviour does not determine the solution when beta > -1/2;
    here it does.) *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow CompliantCone.
Open Scope R_scope.

Section Uniq.
Variables (e beta : R).
Hypothesis He : 0 < e.

(** powers are small *)
Lemma Rpower_le_exp q : exists A, 0 < A /\ forall x, 1 <= x -> Rpower x q <= A * exp (x / 8).
Proof.
set (q' := Rmax q 1).
assert (Hq1 : 1 <= q') by apply Rmax_r. assert (Hq : q <= q') by apply Rmax_l.
exists (Rpower 8 q' * exp (q' * ln q' - q')).
split. apply Rmult_lt_0_compat; apply exp_pos.
intros x Hx.
apply Rle_trans with (Rpower x q').
- destruct (Rle_lt_or_eq_dec _ _ Hx) as [H|<-].
  + apply Rle_Rpower; lra.
  + unfold Rpower. rewrite ln_1, !Rmult_0_r. apply Rle_refl.
- replace (Rpower x q') with (Rpower 8 q' * Rpower (x / 8) q').
  2: { rewrite Rpower_mult_distr by lra. f_equal. field. }
  rewrite Rmult_assoc. apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
  assert (H := Rpower_exp_bound q' (x / 8) ltac:(lra) ltac:(lra)).
  apply Rmult_le_reg_r with (exp (- (x / 8))). apply exp_pos.
  rewrite Rmult_assoc, <- exp_plus. replace (x / 8 + - (x / 8)) with 0 by ring. rewrite exp_0, Rmult_1_r. exact H.
Qed.

Lemma Je_small s : ok s -> small_at_left (Je e s).
Proof.
intros Hs.
assert (HL := Je_left e He s Hs). apply is_lim_spec in HL.
destruct (HL (mkposreal 1 Rlt_0_1)) as [M HM]. simpl in HM.
destruct (Rpower_le_exp (- (s + 1))) as (A & HA & HB).
set (G := Rabs (Gamma (s + 1)) + 1).
assert (HG : 0 < G) by (unfold G; generalize (Rabs_pos (Gamma (s + 1))); lra).
exists (G * A), (- (Rmax 1 (M + 1))).
intros t Ht.
assert (H1 : 1 <= - t) by (generalize (Rmax_l 1 (M + 1)); lra).
assert (H2 : M < - t) by (generalize (Rmax_r 1 (M + 1)); lra).
specialize (HM (- t) H2). rewrite Ropp_involutive in HM.
specialize (HB (- t) H1).
set (X := Rpower (- t) (s + 1)) in *. assert (HX : 0 < X) by apply exp_pos.
assert (HB' : Rabs (Je e s t * X) <= G).
{ replace (Je e s t * X) with (Gamma (s + 1) + (Je e s t * X - Gamma (s + 1))) by ring.
  eapply Rle_trans. apply Rabs_triang. unfold G. lra. }
rewrite Rpower_Ropp in HB. fold X in HB.
replace (Je e s t) with (Je e s t * X * / X) by (field; lra).
rewrite Rabs_mult, (Rabs_pos_eq (/ X)) by (apply Rlt_le, Rinv_0_lt_compat; auto).
rewrite Rmult_assoc. apply Rmult_le_compat; auto using Rabs_pos.
apply Rlt_le, Rinv_0_lt_compat; auto.
Qed.

Lemma small_scal k w : small_at_left w -> small_at_left (fun t => k * w t).
Proof.
intros (A & T & H). exists (Rabs k * A), T. intros t Ht. rewrite Rabs_mult, Rmult_assoc.
apply Rmult_le_compat_l; auto using Rabs_pos.
Qed.

Lemma small_minus w x : small_at_left w -> small_at_left x -> small_at_left (fun t => w t - x t).
Proof.
intros (A & T & H) (B & T' & H'). exists (A + B), (Rmin T T'). intros t Ht.
assert (M1 := Rmin_l T T'). assert (M2 := Rmin_r T T').
eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp.
specialize (H t ltac:(lra)). specialize (H' t ltac:(lra)). lra.
Qed.

Lemma small_ext w x : (forall t, w t = x t) -> small_at_left w -> small_at_left x.
Proof. intros E (A & T & H). exists A, T. intros t Ht. rewrite <- E. auto. Qed.

Hypothesis Hb : not_nat beta.

Lemma Fe_small n : small_at_left (Derive_n (Fe e beta) n).
Proof.
assert (Hg := not_nat_Gamma beta Hb).
apply (small_ext (fun t => / Gamma (- beta) * Je e (INR n - beta - 1) t)).
- intros t. rewrite <- (Fe_derive_n e He beta n t Hb). field; auto.
- apply small_scal, Je_small. replace (INR n - beta - 1) with (- beta - 1 + INR n) by ring.
  apply ok_plus, ok_not_nat, Hb.
Qed.

Lemma Fe_nonzero_left T : exists t, t <= T /\ Fe e beta t <> 0.
Proof.
assert (H := Fe_asymptotics e He beta Hb). apply is_lim_spec in H.
destruct (H (mkposreal (1 / 2) ltac:(lra))) as [M HM]. simpl in HM.
set (x := Rmax (M + 1) (- T)).
assert (X1 : M + 1 <= x) by apply Rmax_l. assert (X2 : - T <= x) by apply Rmax_r.
exists (- x). split. lra. intros E. specialize (HM x ltac:(lra)). rewrite E in HM.
unfold Rdiv in HM. rewrite Rmult_0_l in HM. apply Rabs_def2 in HM. lra.
Qed.

Lemma dev_ode_chain tm f : deviation_equation e beta f -> T_chain e beta tm f (Derive f) (Derive_n f 2) (Derive_n f 3).
Proof.
intros (Hex & H).
assert (D : forall n t, (n < 4)%nat -> is_derive (Derive_n f n) t (Derive_n f (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n f n)). exact (Hex (S n) t Hn). }
refine (conj _ (conj _ (conj _ _))); intros t _.
- apply (D 0%nat); lia.
- apply (D 1%nat); lia.
- apply (D 2%nat); lia.
- replace (e * (- beta * f t + (1 - beta + t) * Derive f t + t * Derive_n f 2 t) - 2 * Derive_n f 3 t)
    with (Derive_n f 4 t). apply (D 3%nat); lia.
  specialize (H t).
  replace (Derive_n f 4 t) with (e * (1 / e * Derive_n f 4 t)) by (field; lra).
  replace (1 / e * Derive_n f 4 t) with
   (- beta * f t + t * Derive f t + (1 - beta) * Derive f t + t * Derive_n f 2 t - 2 / e * Derive_n f 3 t) by lra.
  field. lra.
Qed.

Theorem slow_unique_chain tm w0 w1 w2 w3 : T_chain e beta tm w0 w1 w2 w3 ->
  small_at_left w0 -> small_at_left w1 -> small_at_left w2 -> small_at_left w3 ->
  exists C, forall t : R, Rbar_lt t tm -> w0 t = C * Fe e beta t.
Proof.
intros HT S0 S1 S2 S3.
assert (HX : (exists T : R, T <= (cone_time e beta) /\ forall t, t <= T -> Rbar_lt t tm) \/ forall t : R,
  ~ Rbar_lt t tm).
{ destruct tm as [r| |].
  - left. exists (Rmin (cone_time e beta) (r - 1)). split. apply Rmin_l.
    intros t Ht. simpl. generalize (Rmin_r (cone_time e beta) (r - 1)). lra.
  - left. exists (cone_time e beta). split. apply Rle_refl. intros; exact I.
  - right. intros t Ht. exact Ht. }
destruct HX as [(T & HT1 & HT2)|HX].
2: { exists 0. intros t Ht. exfalso. exact (HX t Ht). }
destruct (Fe_nonzero_left T) as (t0 & Ht0 & Hne).
set (C := w0 t0 / Fe e beta t0). exists C.
destruct (dev_ode_chain tm _ (Fe_ode e He beta Hb)) as (F0 & F1 & F2 & F3).
destruct HT as (D0 & D1 & D2 & D3).
intros t Ht. apply Rminus_diag_uniq.
assert (D : forall (a b a' b' : R -> R), (forall t : R, Rbar_lt t tm -> is_derive a t (a' t)) ->
  (forall t : R, Rbar_lt t tm -> is_derive b t (b' t)) ->
  forall t : R, Rbar_lt t tm -> is_derive (fun t => a t - C * b t) t (a' t - C * b' t)).
{ intros a b a' b' Da Db x Hx. apply (is_derive_minus a (fun t => C * b t)). apply Da, Hx.
  apply (is_derive_scal b), Db, Hx. }
apply ((cone_zero e beta He) tm (fun t => w0 t - C * Fe e beta t) (fun t => w1 t - C * Derive (Fe e beta) t)
  (fun t => w2 t - C * Derive_n (Fe e beta) 2 t) (fun t => w3 t - C * Derive_n (Fe e beta) 3 t) t0).
- refine (conj (D _ _ _ _ D0 F0) (conj (D _ _ _ _ D1 F1) (conj (D _ _ _ _ D2 F2) _))).
  intros x Hx. eapply is_derive_val. apply (D _ _ _ _ D3 F3 x Hx). ring.
- apply HT2; lra.
- apply small_minus; auto. apply small_scal. exact (Fe_small 0).
- apply small_minus; auto. apply small_scal. exact (Fe_small 1).
- apply small_minus; auto. apply small_scal. exact (Fe_small 2).
- apply small_minus; auto. apply small_scal. exact (Fe_small 3).
- lra.
- unfold C. field; auto.
- exact Ht.
Qed.

(** Only the growth of w itself is needed. *)
Theorem slow_unique_chain0 tm w0 w1 w2 w3 : T_chain e beta tm w0 w1 w2 w3 ->
  (exists A T1, forall t, t <= T1 -> Rabs (w0 t) <= A * exp (- t / 16)) ->
  exists C, forall t : R, Rbar_lt t tm -> w0 t = C * Fe e beta t.
Proof.
intros HT HG.
destruct (Classical_Prop.classic (exists r : R, Rbar_lt r tm)) as [Hr|Hr].
- destruct ((growth_of_w0 e beta He) tm w0 w1 w2 w3 HT Hr HG) as (S0 & S1 & S2 & S3).
  apply (slow_unique_chain tm w0 w1 w2 w3); auto.
- exists 0. intros t Ht. exfalso. apply Hr. exists t; auto.
Qed.

(** Uniqueness of the slow solution: growth below e^(|T|/16) of f alone. *)
Theorem slow_unique0 f : deviation_equation e beta f ->
  (exists A T1, forall t, t <= T1 -> Rabs (f t) <= A * exp (- t / 16)) ->
  exists C, forall t, f t = C * Fe e beta t.
Proof.
intros Hf HG.
destruct (slow_unique_chain0 p_infty f (Derive f) (Derive_n f 2) (Derive_n f 3) (dev_ode_chain p_infty f Hf) HG)
  as (C & HC).
exists C. intros t. apply HC. exact I.
Qed.

(** Hence F_beta is the only solution with f(-x) / x^beta -> 1. *)
Theorem slow_characterized f : deviation_equation e beta f ->
  is_lim (fun x => f (- x) / Rpower x beta) p_infty 1 -> forall t, f t = Fe e beta t.
Proof.
intros Hf HL.
assert (HG : exists A T1, forall t, t <= T1 -> Rabs (f t) <= A * exp (- t / 16)).
{ assert (HL' := HL). apply is_lim_spec in HL'.
  destruct (HL' (mkposreal 1 Rlt_0_1)) as [M HM]. simpl in HM.
  destruct (Rpower_le_exp beta) as (A & HA & HP).
  exists (2 * (Rpower 2 beta * A)), (- (Rmax 2 (M + 1))). intros t Ht.
  assert (M1 := Rmax_l 2 (M + 1)). assert (M2 := Rmax_r 2 (M + 1)).
  specialize (HM (- t) ltac:(lra)). rewrite Ropp_involutive in HM.
  specialize (HP (- t / 2) ltac:(lra)). replace (- t / 2 / 8) with (- t / 16) in HP by field.
  assert (EX : Rpower (- t) beta = Rpower 2 beta * Rpower (- t / 2) beta).
  { rewrite Rpower_mult_distr by lra. f_equal. field. }
  set (X := Rpower (- t) beta) in *. assert (HX : 0 < X) by apply exp_pos.
  assert (Hq : Rabs (f t / X) <= 2).
  { replace (f t / X) with (1 + (f t / X - 1)) by ring. eapply Rle_trans. apply Rabs_triang. rewrite Rabs_R1. lra. }
  replace (f t) with (f t / X * X) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq X) by lra.
  apply Rle_trans with (2 * X). apply Rmult_le_compat_r; lra.
  rewrite Rmult_assoc. apply Rmult_le_compat_l. lra.
  rewrite EX, Rmult_assoc. apply Rmult_le_compat_l; auto. apply Rlt_le, exp_pos. }
destruct (slow_unique0 f Hf HG) as (C & HC).
assert (HF := Fe_asymptotics e He beta Hb).
assert (HL2 : is_lim (fun x => f (- x) / Rpower x beta) p_infty (C * 1)).
{ apply (is_lim_ext (fun x => C * (Fe e beta (- x) / Rpower x beta))).
  - intros x. rewrite HC. unfold Rdiv. ring.
  - apply (is_lim_scal_l _ C p_infty 1), HF. }
assert (E : Finite 1 = Finite (C * 1)).
{ rewrite <- (is_lim_unique _ _ _ HL). apply is_lim_unique, HL2. }
injection E. intros E' t. rewrite HC. rewrite Rmult_1_r in E'. rewrite <- E'. ring.
Qed.

End Uniq.
