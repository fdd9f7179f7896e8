(** * a -> 0 and d -> oo

    The boundary terms become small, uniformly on |t| <= T. The data at t = 0 become values of Gamma, by the
    substitution x = r^3/3. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral.
Open Scope R_scope.

Definition trunc : (R * R -> Prop) -> Prop :=
  filter_prod (at_right 0) (Rbar_locally p_infty).

Global Instance trunc_proper : ProperFilter trunc.
Proof. apply filter_prod_proper. Qed.

Lemma trunc_and (P Q : R * R -> Prop) :
  trunc P -> trunc Q -> trunc (fun x => P x /\ Q x).
Proof. intros HP HQ. exact (filter_and P Q HP HQ). Qed.

Lemma trunc_imp (P Q : R * R -> Prop) :
  (forall x, P x -> Q x) -> trunc P -> trunc Q.
Proof. intros H. exact (filter_imp P Q H). Qed.

Lemma trunc_left (P : R -> Prop) : at_right 0 P -> trunc (fun ad => P (fst ad)).
Proof.
intros H. exists P (fun _ => True); auto. exists 0; auto.
Qed.

Lemma trunc_right (P : R -> Prop) : Rbar_locally p_infty P -> trunc (fun ad => P (snd ad)).
Proof.
intros H. exists (fun _ => True) P; auto. exists (mkposreal _ Rlt_0_1); auto.
Qed.

Lemma at_right_lt (m : R) : 0 < m -> at_right 0 (fun a => 0 < a < m).
Proof.
intros Hm; exists (mkposreal m Hm); intros y Hy Hy0.
split; auto. apply Rabs_def2 in Hy. unfold minus, plus, opp in Hy; simpl in Hy. lra.
Qed.

Lemma trunc_basic : trunc (fun ad => 0 < fst ad < 1 /\ 2 < snd ad).
Proof.
apply filter_and.
- apply (trunc_left (fun a => 0 < a < 1)), at_right_lt, Rlt_0_1.
- apply (trunc_right (fun d => 2 < d)). exists 2; auto.
Qed.

(** boundary terms *)

Lemma kernel_small_left (s T eta : R) : 0 < s -> 0 <= T -> 0 < eta ->
  at_right 0 (fun a => forall t, Rabs t <= T -> kernel s t a <= eta).
Proof.
intros Hs HT He.
set (e1 := eta * exp (- T)).
assert (He1 : 0 < e1) by (apply Rmult_lt_0_compat; auto; apply exp_pos).
set (m := Rmin 1 (Rpower e1 (/ s))).
assert (Hm : 0 < m) by (unfold m, Rpower; apply Rmin_pos; [lra|apply exp_pos]).
generalize (at_right_lt m Hm). apply filter_imp.
intros a [Ha Ham] t Ht.
assert (Ha1 : a < 1) by (eapply Rlt_le_trans; [exact Ham|apply Rmin_l]).
assert (Ha2 : a < Rpower e1 (/ s)) by (eapply Rlt_le_trans; [exact Ham|apply Rmin_r]).
unfold kernel.
replace eta with (e1 * exp T).
2: { unfold e1; rewrite Rmult_assoc, <- exp_plus.
     replace (- T + T) with 0 by ring. rewrite exp_0; ring. }
apply Rmult_le_compat.
- apply Rlt_le, exp_pos.
- apply Rlt_le, exp_pos.
- replace e1 with (Rpower (Rpower e1 (/ s)) s).
  apply Rle_Rpower_l; lra.
  rewrite Rpower_mult, Rinv_l by lra. apply Rpower_1, He1.
- assert (a * t - a ^ 3 / 3 <= T).
  { apply Rabs_le_between in Ht.
    assert (0 < a ^ 3) by (apply pow_lt; auto).
    destruct (Rle_lt_dec 0 t); nra. }
  destruct (Rle_lt_or_eq_dec _ _ H) as [H'|H'].
  apply Rlt_le, exp_increasing, H'. rewrite H'; apply Rle_refl.
Qed.

Lemma kernel_small_right (s T eta : R) : 0 < s -> 0 <= T -> 0 < eta ->
  Rbar_locally p_infty (fun d => forall t, Rabs t <= T -> kernel s t d <= eta).
Proof.
intros Hs HT He.
exists (Rmax (3 * (s + T + 1)) (- ln eta)).
intros d Hd t Ht.
assert (Hd1 : 3 * (s + T + 1) < d) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hd]).
assert (Hd2 : - ln eta < d) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hd]).
assert (H0 : 1 < d) by lra.
unfold kernel, Rpower. rewrite <- exp_plus.
rewrite <- (exp_ln eta) by exact He.
apply exp_le.
generalize (ln_le_sub1 d ltac:(lra)); intros Hln.
apply Rabs_le_between in Ht.
assert (s * ln d <= s * d) by (apply Rmult_le_compat_l; lra).
assert (d * t <= d * T) by (apply Rmult_le_compat_l; lra).
assert (H3 : d * d >= d * 1) by (apply Rmult_ge_compat_l; lra).
assert (d * (d * d) >= d * (3 * (s + T + 1))) by (apply Rmult_ge_compat_l; lra).
simpl. rewrite Rmult_1_r. lra.
Qed.

Lemma boundary_small (s T eta : R) : 0 < s -> 0 <= T -> 0 < eta ->
  trunc (fun ad => forall t, Rabs t <= T ->
     Rabs (kernel s t (fst ad) - kernel s t (snd ad)) <= eta).
Proof.
intros Hs HT He.
generalize (filter_and _ _
  (trunc_left _ (kernel_small_left s T eta Hs HT He))
  (trunc_right _ (kernel_small_right s T eta Hs HT He))).
apply filter_imp. intros [a d] [H1 H2] t Ht; simpl in *.
specialize (H1 t Ht); specialize (H2 t Ht).
generalize (kernel_pos s t a) (kernel_pos s t d); intros.
apply Rabs_le_between; lra.
Qed.

(** initial values: substitution x = r^3/3 *)

Definition gamma_integrand (x t : R) : R := Rpower t (x - 1) * exp (- t).

Definition is_GammaInt (x G : R) : Prop :=
  is_RInt_gen (gamma_integrand x) (at_right 0) (Rbar_locally p_infty) G.

Lemma continuous_gamma_integrand x t : 0 < t -> continuous (gamma_integrand x) t.
Proof.
intros Hr. apply (ex_derive_continuous (gamma_integrand x) t).
unfold gamma_integrand, Rpower. auto_derive; auto.
Qed.

Lemma M0_gamma s a d : 0 < a -> a <= d ->
  M s a d 0 = Rpower 3 ((s - 2) / 3) * RInt (gamma_integrand ((s + 1) / 3)) (a ^ 3 / 3) (d ^ 3 / 3).
Proof.
intros Ha Hd.
assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
assert (H : is_RInt (fun y => scal (y ^ 2) (gamma_integrand ((s + 1) / 3) (y ^ 3 / 3))) a d
   (RInt (gamma_integrand ((s + 1) / 3)) (a ^ 3 / 3) (d ^ 3 / 3))).
{ apply (is_RInt_comp (gamma_integrand ((s + 1) / 3)) (fun y => y ^ 3 / 3) (fun y => y ^ 2)).
  - intros x Hx; rewrite Hmin in Hx. apply continuous_gamma_integrand.
    assert (0 < x ^ 3) by (apply pow_lt; lra). lra.
  - intros x Hx; split.
    + auto_derive; auto. field.
    + apply (ex_derive_continuous (fun y => y ^ 2)). auto_derive; auto. }
apply (is_RInt_scal _ _ _ (Rpower 3 ((s - 2) / 3))) in H.
unfold M. apply is_RInt_unique.
eapply is_RInt_ext; [|exact H].
intros r Hr; rewrite Hmin in Hr.
assert (Hr0 : 0 < r) by lra.
change (Rpower 3 ((s - 2) / 3) *
  (r ^ 2 * (Rpower (r ^ 3 / 3) ((s + 1) / 3 - 1) * exp (- (r ^ 3 / 3))))
  = Rpower r s * exp (r * 0 - r ^ 3 / 3)).
replace (r * 0 - r ^ 3 / 3) with (- (r ^ 3 / 3)) by ring.
rewrite <- !Rmult_assoc. f_equal.
rewrite <- (Rpower_pow 2 r) by auto.
unfold Rpower. rewrite <- !exp_plus. f_equal.
replace (ln (r ^ 3 / 3)) with (3 * ln r - ln 3).
simpl (INR 2). field.
unfold Rdiv. rewrite ln_mult, ln_Rinv, ln_pow; try lra.
simpl (INR 3); ring.
apply pow_lt; lra.
Qed.

Lemma cube3_right0 : filterlim (fun a => a ^ 3 / 3) (at_right 0) (at_right 0).
Proof.
intros P [e He].
assert (Hm : 0 < Rmin 1 e) by (apply Rmin_pos; [lra|apply cond_pos]).
generalize (at_right_lt _ Hm). unfold filtermap. apply filter_imp.
intros a [Ha Ham].
assert (a < 1) by (eapply Rlt_le_trans; [exact Ham|apply Rmin_l]).
assert (a < e) by (eapply Rlt_le_trans; [exact Ham|apply Rmin_r]).
assert (0 < a ^ 3) by (apply pow_lt; auto).
assert (a * a < 1) by nra.
assert (a ^ 3 < a) by (simpl; rewrite Rmult_1_r; nra).
apply He; [|lra].
apply Rabs_def1; unfold minus, plus, opp; simpl; simpl in H1, H3; lra.
Qed.

Lemma cube3_infty : filterlim (fun a => a ^ 3 / 3) (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof.
intros P [m Hm].
exists (Rmax 3 m). intros d Hd. apply Hm.
assert (H1 : 3 < d) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hd]).
assert (H2 : m < d) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hd]).
assert (9 < d * d) by nra.
assert (d * 9 < d * (d * d)) by nra.
simpl. lra.
Qed.

Lemma M0_lim (s G : R) : is_GammaInt ((s + 1) / 3) G ->
  forall eps : posreal,
  trunc (fun ad => Rabs (M s (fst ad) (snd ad) 0 - Rpower 3 ((s - 2) / 3) * G) < eps).
Proof.
intros HG eps.
set (C := Rpower 3 ((s - 2) / 3)).
assert (HC : 0 < C) by apply exp_pos.
assert (He : 0 < eps / C) by (apply Rdiv_lt_0_compat; auto; apply cond_pos).
unfold is_GammaInt, is_RInt_gen in HG.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in HG.
specialize (HG (mkposreal _ He)).
destruct HG as [Q S HQ HS HQS].
generalize (filter_and _ _ trunc_basic (filter_and _ _
   (trunc_left _ (cube3_right0 _ HQ)) (trunc_right _ (cube3_infty _ HS)))).
apply filter_imp. intros [a d]; unfold filtermap; simpl. intros [[H1 H2] [H3 H4]].
destruct (HQS _ _ H3 H4) as [z [Hz1 Hz2]]; simpl in Hz1.
apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
rewrite M0_gamma by lra. fold C. simpl (a ^ 3) in *. simpl (d ^ 3) in *.
rewrite Hz1.
rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq C) by lra.
unfold ball in Hz2; simpl in Hz2; unfold AbsRing_ball, abs, minus, plus, opp in Hz2; simpl in Hz2.
replace (pos eps) with (C * (eps / C)) by (field; lra).
apply Rmult_lt_compat_l; auto.
Qed.

Lemma trunc_smaller (e m : R) : 0 < e -> trunc (fun ad => 0 < fst ad < e /\ m < snd ad).
Proof.
intros He. apply trunc_and.
- apply (trunc_left (fun a => 0 < a < e)), at_right_lt, He.
- apply (trunc_right (fun d => m < d)). exists m; auto.
Qed.
