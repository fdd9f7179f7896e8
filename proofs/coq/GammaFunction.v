(** * Gamma

    Euler's integral converges for x > 0 (its integrand is below an explicit derivative), Gamma(x + 1) = x Gamma(x) (the
    truncated integrals at t = 0 give it), Gamma(1) = 1, the continuation to x < 0, its zeros (none) and signs, and
    uniqueness. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit.
Open Scope R_scope.

Lemma ex_RInt_gen_bounded (f : R -> R) (B : R) :
  (forall t, 0 < t -> 0 <= f t) ->
  (forall t, 0 < t -> continuous f t) ->
  (forall a d, 0 < a -> a <= d -> RInt f a d <= B) ->
  exists l, is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l
            /\ forall a d, 0 < a -> a <= d -> RInt f a d <= l.
Proof.
intros Hpos Hcont HB.
assert (Hex : forall a d, 0 < a -> a <= d -> ex_RInt f a d).
{ intros a d Ha Hd. apply (ex_RInt_continuous f).
  intros z Hz; rewrite Rmin_left in Hz by lra. apply Hcont; lra. }
destruct (completeness (fun v => exists a d, 0 < a /\ a <= d /\ v = RInt f a d))
  as [l [Hub Hlub]].
- exists B. intros v (a & d & Ha & Hd & ->). auto.
- exists (RInt f 1 1), 1, 1. repeat split; lra.
- assert (Hle : forall a d, 0 < a -> a <= d -> RInt f a d <= l).
  { intros a d Ha Hd; apply Hub. exists a, d; auto. }
  exists l; split; auto.
  unfold is_RInt_gen.
  rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))).
  intros eps.
  assert (Hne : exists a0 d0, 0 < a0 /\ a0 <= d0 /\ l - eps < RInt f a0 d0).
  { destruct (Classical_Prop.classic (exists a0 d0, 0 < a0 /\ a0 <= d0 /\ l - eps < RInt f a0 d0)) as [H|H]; auto.
    exfalso. assert (l <= l - eps).
    { apply Hlub. intros v (a & d & Ha & Hd & ->).
      apply Rnot_lt_le. intros Hlt. apply H. exists a, d; auto. }
    generalize (cond_pos eps); lra. }
  destruct Hne as (a0 & d0 & Ha0 & Hd0 & Hlt).
  apply (Filter_prod _ _ _ (fun a => 0 < a < a0) (fun d => d0 < d)).
  + apply at_right_lt; auto.
  + exists d0; auto.
  + intros a d [Ha Haa] Hd; simpl.
    exists (RInt f a d). split.
    * apply (RInt_correct f), Hex; lra.
    * assert (H1 := Hle a d Ha ltac:(lra)).
      assert (H2 : RInt f a0 d0 <= RInt f a d).
      { rewrite <- (RInt_Chasles f a a0 d) by (apply Hex; lra).
        rewrite <- (RInt_Chasles f a0 d0 d) by (apply Hex; lra).
        assert (0 <= RInt f a a0).
        { apply RInt_ge_0; try lra. apply Hex; lra. intros; apply Hpos; lra. }
        assert (0 <= RInt f d0 d).
        { apply RInt_ge_0; try lra. apply Hex; lra. intros; apply Hpos; lra. }
        unfold plus; simpl. lra. }
      apply Rabs_def1; unfold minus, plus, opp; simpl; lra.
Qed.

Lemma gamma_integrand_pos x t : 0 < gamma_integrand x t.
Proof. unfold gamma_integrand, Rpower; apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma ex_RInt_gamma_integrand x a d : 0 < a -> a <= d -> ex_RInt (gamma_integrand x) a d.
Proof.
intros Ha Hd. apply (ex_RInt_continuous (gamma_integrand x)).
intros z Hz; rewrite Rmin_left in Hz by lra. apply continuous_gamma_integrand; lra.
Qed.

Section Bound.
Variable x : R.
Hypothesis Hx : 0 < x.
Let C := exp ((x + 1) * ln (x + 1) - x).
Let P t := C / x * exp (x * (ln t - ln (1 + t))).
Let P' t := C / (t * (1 + t)) * exp (x * (ln t - ln (1 + t))).

Lemma P_derive t : 0 < t -> is_derive P t (P' t).
Proof.
intros Ht; unfold P, P'.
auto_derive. repeat split; lra.
replace (ln t + - ln (1 + t)) with (ln t - ln (1 + t)) by ring.
field; lra.
Qed.

Lemma P_continuous t : 0 < t -> continuous P' t.
Proof.
intros Ht. apply (ex_derive_continuous P' t). unfold P'.
auto_derive. repeat split; try lra. apply Rgt_not_eq; nra.
Qed.

Lemma gamma_integrand_le t : 0 < t -> gamma_integrand x t <= P' t.
Proof.
intros Ht; unfold gamma_integrand, P', C, Rpower.
assert (H0 : 0 < t * (1 + t)) by nra.
rewrite <- (exp_ln (t * (1 + t))) at 1 by exact H0.
unfold Rdiv. rewrite <- exp_Ropp, <- !exp_plus.
apply exp_le.
rewrite ln_mult by lra.
assert (H : ln ((1 + t) / (x + 1)) <= (1 + t) / (x + 1) - 1)
  by (apply ln_le_sub1, Rdiv_lt_0_compat; lra).
unfold Rdiv in H at 1. rewrite ln_mult, ln_Rinv in H; try lra.
2: apply Rinv_0_lt_compat; lra.
apply (Rmult_le_compat_l (x + 1)) in H; [|lra].
replace ((x + 1) * ((1 + t) / (x + 1) - 1)) with (t - x) in H by (field; lra).
lra.
Qed.

Lemma RInt_gamma_integrand_bound a d : 0 < a -> a <= d -> RInt (gamma_integrand x) a d <= C / x.
Proof.
intros Ha Hd.
assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
assert (H : is_RInt P' a d (P d - P a)).
{ apply (is_RInt_derive P).
  - intros r Hr; rewrite Hmin in Hr; apply P_derive; lra.
  - intros r Hr; rewrite Hmin in Hr; apply P_continuous; lra. }
apply Rle_trans with (RInt P' a d).
- apply RInt_le; auto. apply ex_RInt_gamma_integrand; auto. eexists; exact H.
  intros; apply gamma_integrand_le; lra.
- apply (is_RInt_unique (V := R_CompleteNormedModule)) in H. rewrite H.
  assert (HC : 0 < C / x) by (apply Rdiv_lt_0_compat; auto; apply exp_pos).
  assert (0 < P a) by (apply Rmult_lt_0_compat; auto; apply exp_pos).
  assert (P d <= C / x * 1).
  { apply Rmult_le_compat_l. lra. apply Rle_trans with (exp 0).
    2: rewrite exp_0; apply Rle_refl.
    apply exp_le.
    assert (Hln : ln d < ln (1 + d)) by (apply ln_increasing; lra).
    assert (x * (ln (1 + d) - ln d) >= 0) by (apply Rle_ge, Rmult_le_pos; lra). lra. }
  lra.
Qed.

End Bound.

Lemma GammaInt_aux x : 0 < x -> is_GammaInt x (GammaInt x) /\ 0 < GammaInt x.
Proof.
intros Hx.
destruct (ex_RInt_gen_bounded (gamma_integrand x) (exp ((x + 1) * ln (x + 1) - x) / x)) as [l [Hl Hle]].
- intros; apply Rlt_le, gamma_integrand_pos.
- intros; apply continuous_gamma_integrand; auto.
- apply RInt_gamma_integrand_bound, Hx.
- assert (H : GammaInt x = l).
  { apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ l). exact Hl. }
  rewrite H. split; auto.
  eapply Rlt_le_trans; [|apply (Hle 1 2); lra].
  apply RInt_gt_0; try lra. intros; apply gamma_integrand_pos.
  intros; apply continuous_gamma_integrand; lra.
Qed.

Lemma is_GammaInt_correct x : 0 < x -> is_GammaInt x (GammaInt x).
Proof. intros; now apply GammaInt_aux. Qed.

Lemma GammaInt_pos x : 0 < x -> 0 < GammaInt x.
Proof. intros; now apply GammaInt_aux. Qed.

(** The functional equation, for free from the total derivative at t = 0. *)
Lemma GammaInt_rec x : 0 < x -> GammaInt (x + 1) = x * GammaInt x.
Proof.
intros Hx.
set (c := 3 * x - 1).
assert (H1 : is_GammaInt ((c + 1) / 3) (GammaInt x)).
{ replace ((c + 1) / 3) with x by (unfold c; field). apply is_GammaInt_correct, Hx. }
assert (H2 : is_GammaInt ((c + 3 + 1) / 3) (GammaInt (x + 1))).
{ replace ((c + 3 + 1) / 3) with (x + 1) by (unfold c; field).
  apply is_GammaInt_correct; lra. }
set (C := Rpower 3 x).
assert (HC : 0 < C) by apply exp_pos.
assert (E1 : Rpower 3 ((c - 2) / 3) = C / 3).
{ unfold C. replace ((c - 2) / 3) with (x + - (1)) by (unfold c; field).
  rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by lra. reflexivity. }
assert (E2 : Rpower 3 ((c + 3 - 2) / 3) = C).
{ unfold C. f_equal. unfold c; field. }
apply Rminus_diag_uniq.
assert (Hz : forall e, 0 < e -> Rabs (C * GammaInt (x + 1) - x * C * GammaInt x) < (2 + 3 * x) * e).
{ intros e He.
  destruct (filter_ex (F := trunc) _ (trunc_and _ _ trunc_basic (trunc_and _ _
     (boundary_small (c + 1) 0 e ltac:(unfold c; lra) (Rle_refl 0) He)
     (trunc_and _ _ (M0_lim _ _ H1 (mkposreal _ He)) (M0_lim _ _ H2 (mkposreal _ He))))))
    as [[a d] [[Ha Hd] [Hb [Hm1 Hm2]]]]; simpl in *.
  specialize (Hb 0 ltac:(rewrite Rabs_R0; lra)).
  rewrite M_ode, E2 in Hm2 by lra. rewrite E1 in Hm1.
  apply Rabs_le_between in Hb. apply Rabs_def2 in Hm1. apply Rabs_def2 in Hm2.
  replace (c + 1) with (3 * x) in * by (unfold c; ring).
  assert (3 * x * (M c a d 0 - C / 3 * GammaInt x) < 3 * x * e) by (apply Rmult_lt_compat_l; lra).
  assert (3 * x * (- e) < 3 * x * (M c a d 0 - C / 3 * GammaInt x)) by (apply Rmult_lt_compat_l; lra).
  apply Rabs_def1; lra. }
destruct (Req_dec (GammaInt (x + 1) - x * GammaInt x) 0) as [H|H]; auto.
exfalso.
assert (Hp : 0 < Rabs (C * GammaInt (x + 1) - x * C * GammaInt x)).
{ apply Rabs_pos_lt. replace (C * GammaInt (x + 1) - x * C * GammaInt x)
    with (C * (GammaInt (x + 1) - x * GammaInt x)) by ring.
  apply Rmult_integral_contrapositive_currified; auto. lra. }
assert (Hq : 0 < 2 + 3 * x) by lra.
specialize (Hz _ (Rdiv_lt_0_compat _ _ Hp Hq)).
replace ((2 + 3 * x) * (Rabs (C * GammaInt (x + 1) - x * C * GammaInt x) / (2 + 3 * x)))
  with (Rabs (C * GammaInt (x + 1) - x * C * GammaInt x)) in Hz by (field; lra).
lra.
Qed.

(** The number of steps up to a positive argument, by which Gamma and 1/Gamma recur. *)
Lemma steps_up_zero x : 0 < x -> Z.to_nat (up (- x)) = 0%nat.
Proof.
intros Hx. destruct (archimed (- x)) as [H1 H2].
assert (H : (up (- x) < 1)%Z) by (apply lt_IZR; lra).
destruct (up (- x)); simpl; auto; lia.
Qed.

Lemma steps_up_next x : x <= 0 -> Z.to_nat (up (- x)) = S (Z.to_nat (up (- (x + 1)))).
Proof.
intros Hx. destruct (archimed (- x)) as [H1 H2].
assert (Hp : (0 < up (- x))%Z) by (apply lt_IZR; lra).
assert (Hup : up (- x) = (1 + up (- (x + 1)))%Z).
{ rewrite <- (tech_up (- x) (1 + up (- (x + 1)))%Z); auto;
  rewrite plus_IZR; destruct (archimed (- (x + 1))); lra. }
lia.
Qed.

Lemma Gamma_GammaInt x : 0 < x -> Gamma x = GammaInt x.
Proof. intros Hx. unfold Gamma. rewrite steps_up_zero by auto. reflexivity. Qed.

Lemma Gamma_rec x : x <> 0 -> Gamma (x + 1) = x * Gamma x.
Proof.
intros Hx.
destruct (Rle_lt_dec x 0) as [H|H].
- unfold Gamma. rewrite (steps_up_next x H). simpl. field; auto.
- rewrite !Gamma_GammaInt by lra. apply GammaInt_rec, H.
Qed.

Lemma Gamma_pos x : 0 < x -> 0 < Gamma x.
Proof. intros Hx; rewrite Gamma_GammaInt by exact Hx. apply GammaInt_pos, Hx. Qed.

Lemma Gamma_correct x : 0 < x ->
  is_RInt_gen (fun t => Rpower t (x - 1) * exp (- t))
    (at_right 0) (Rbar_locally p_infty) (Gamma x).
Proof. intros Hx; rewrite Gamma_GammaInt by exact Hx. apply is_GammaInt_correct, Hx. Qed.

Lemma Gamma_is x : 0 < x -> is_GammaInt x (Gamma x).
Proof. intros Hx. exact (Gamma_correct x Hx). Qed.

Lemma Gamma_neq0 x : (forall n : nat, x <> - INR n) -> Gamma x <> 0.
Proof.
intros Hx H0.
assert (H : forall n, Gamma (x + INR n) = 0).
{ induction n as [|n IH].
  - simpl; rewrite Rplus_0_r; exact H0.
  - rewrite S_INR, <- Rplus_assoc, Gamma_rec, IH. ring.
    specialize (Hx n); lra. }
assert (Hex : exists n : nat, - x < INR n).
{ destruct (Rle_lt_dec 0 (- x)) as [Hx0|Hx0].
  - destruct (nfloor_ex (- x) Hx0) as [n [_ Hn]]. exists (S n). rewrite S_INR; lra.
  - exists O; exact Hx0. }
destruct Hex as [n Hn].
assert (Hp : 0 < Gamma (x + INR n)) by (apply Gamma_pos; lra).
rewrite H in Hp; lra.
Qed.

Lemma Gamma_neg b : 0 < b < 1 -> Gamma (- b) < 0.
Proof.
intros Hb.
assert (H : 0 < Gamma (- b + 1)) by (apply Gamma_pos; lra).
rewrite Gamma_rec in H by lra. nra.
Qed.

Lemma Gamma_12 b : 1 < b < 2 -> 0 < Gamma (- b).
Proof.
intros Hb. assert (H : Gamma (- (b - 1)) < 0) by (apply Gamma_neg; lra).
replace (- (b - 1)) with (- b + 1) in H by ring. rewrite Gamma_rec in H by lra. nra.
Qed.

Lemma Gamma_rising x n : (forall k : nat, x <> - INR k) ->
  Gamma (x + INR n) = rising x n * Gamma x.
Proof.
intros Hx; induction n as [|n IH].
- simpl. rewrite Rplus_0_r. ring.
- rewrite S_INR, <- Rplus_assoc, Gamma_rec, IH. simpl rising. ring.
  specialize (Hx n); lra.
Qed.

Lemma rising_neq0 x n : (forall k : nat, x <> - INR k) -> rising x n <> 0.
Proof.
intros Hx; induction n as [|n IH]; simpl.
- lra.
- apply Rmult_integral_contrapositive_currified; auto. specialize (Hx n); lra.
Qed.

(** Gamma 1 = 1. *)
Lemma Gamma_1 : Gamma 1 = 1.
Proof.
rewrite Gamma_GammaInt by lra.
apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ 1).
apply (filterlimi_lim_ext_loc (fun ad => exp (- fst ad) - exp (- snd ad))).
- generalize trunc_basic. apply trunc_imp. intros [a d] [Ha Hd]; simpl in *.
  assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
  replace (exp (- a) - exp (- d)) with (minus (- exp (- d)) (- exp (- a)))
    by (unfold minus, plus, opp; simpl; ring).
  apply (is_RInt_ext (fun t => exp (- t))).
  + intros x Hx; rewrite Hmin in Hx.
    replace (1 - 1) with 0 by ring. rewrite Rpower_O by lra. symmetry; apply Rmult_1_l.
  + apply (is_RInt_derive (fun t => - exp (- t)) (fun t => exp (- t))).
    * intros x _. auto_derive; auto; ring.
    * intros x _. apply (ex_derive_continuous (fun t => exp (- t))). auto_derive; auto.
- apply filterlim_locally. intros eps.
  assert (He := cond_pos eps).
  assert (Hm : 0 < Rmin (eps / 2) 1) by (apply Rmin_pos; lra).
  generalize (trunc_and _ _ (trunc_left _ (at_right_lt _ Hm))
    (trunc_right (fun d => Rmax 0 (- ln (eps / 2)) < d) (ex_intro _ _ (fun x H => H)))).
  apply trunc_imp. intros [a d]; simpl; intros [[Ha Ham] Hd].
  assert (Ha2 : a < eps / 2) by (eapply Rlt_le_trans; [exact Ham|apply Rmin_l]).
  assert (Hd2 : - ln (eps / 2) < d) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hd]).
  assert (H1 : 1 - a <= exp (- a)) by (generalize (exp_ineq1_le (- a)); lra).
  assert (H2 : exp (- d) < eps / 2).
  { rewrite <- (exp_ln (eps / 2)) by lra. apply exp_increasing; lra. }
  assert (H3 : exp (- a) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
  generalize (exp_pos (- d)); intros.
  apply Rabs_def1; unfold minus, plus, opp; simpl; lra.
Qed.

(** [Gamma] is the only function with Euler's integral on x > 0 and the
    functional equation away from the poles. *)
Theorem Gamma_unique (G : R -> R) :
  (forall x, 0 < x -> is_RInt_gen (fun t => Rpower t (x - 1) * exp (- t))
     (at_right 0) (Rbar_locally p_infty) (G x)) ->
  (forall x, (forall n : nat, x <> - INR n) -> G (x + 1) = x * G x) ->
  forall x, (forall n : nat, x <> - INR n) -> G x = Gamma x.
Proof.
intros Hint Hrec.
assert (Hpos : forall x, 0 < x -> G x = Gamma x).
{ intros x Hx. rewrite Gamma_GammaInt by exact Hx. symmetry.
  apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ (G x)). apply Hint, Hx. }
assert (H : forall n x, 0 < x + INR n -> (forall n : nat, x <> - INR n) -> G x = Gamma x).
{ induction n as [|n IH]; intros x Hx Hn.
  - apply Hpos. simpl in Hx; lra.
  - assert (H0 := Hn 0%nat). simpl in H0.
    assert (E : G (x + 1) = Gamma (x + 1)).
    { apply IH. rewrite S_INR in Hx; lra.
      intros k Hk. apply (Hn (S k)). rewrite S_INR; lra. }
    rewrite Hrec, Gamma_rec in E; auto; try lra.
    apply Rmult_eq_reg_l with x; auto; lra. }
intros x Hn.
destruct (Rle_lt_dec 0 (- x)) as [Hx|Hx].
- destruct (nfloor_ex (- x) Hx) as [n [_ Hlt]].
  apply (H (S n)); auto. rewrite S_INR; lra.
- apply Hpos; lra.
Qed.
