(** * Improper integrals on (0, oo)

    Equality and inequalities of integrands, substitution r = x rho, int r^(s-1) e^(-xr) dr = Gamma(s) x^(-s). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction.
Open Scope R_scope.

Lemma improper_ext (f g : R -> R) l :
  (forall r, 0 < r -> f r = g r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l ->
  is_RInt_gen g (at_right 0) (Rbar_locally p_infty) l.
Proof.
intros E. apply is_RInt_gen_ext.
generalize trunc_basic. apply trunc_imp. intros [a d] [Ha Hd] x Hx; simpl in *.
rewrite Rmin_left in Hx by lra. apply E; lra.
Qed.

Lemma improper_pos (f : R -> R) l :
  (forall r, 0 < r -> 0 <= f r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l -> 0 <= l.
Proof.
intros Hf Hl.
apply Rnot_lt_le. intros Hlt.
assert (Hp : 0 < - l) by lra.
unfold is_RInt_gen in Hl.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in Hl.
destruct (filter_ex (F := trunc) _ (trunc_and _ _ trunc_basic (Hl (mkposreal _ Hp))))
  as [[a d] [[Ha Hd] [z [Hz1 Hz2]]]]; simpl in *.
assert (0 <= z).
{ apply (is_RInt_ge_0 f a d); try lra. exact Hz1. intros; apply Hf; lra. }
apply Rabs_def2 in Hz2; unfold minus, plus, opp in Hz2; simpl in Hz2. lra.
Qed.

(** int_0^oo r^(s-1) exp(-x r) dr = Gamma(s) x^(-s) *)
Lemma Gamma_scaled s x : 0 < s -> 0 < x ->
  is_RInt_gen (fun r => Rpower r (s - 1) * exp (- (x * r)))
    (at_right 0) (Rbar_locally p_infty) (Rpower x (- s) * Gamma s).
Proof.
intros Hs Hx.
assert (HG := Gamma_is s Hs).
unfold is_GammaInt, is_RInt_gen in *.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in HG |- *.
intros eps.
set (C := Rpower x (- s)). assert (HC : 0 < C) by apply exp_pos.
assert (He : 0 < eps / C) by (apply Rdiv_lt_0_compat; auto; apply cond_pos).
destruct (HG (mkposreal _ He)) as [Q S [e HQ] [m HS] HQS].
assert (Hex : 0 < e / x) by (apply Rdiv_lt_0_compat; auto; apply cond_pos).
generalize (trunc_and _ _ trunc_basic (trunc_smaller (e / x) (m / x) Hex)).
apply trunc_imp. intros [a d]; simpl; intros [[H1 H2] [H3 H4]].
assert (Hxa : 0 < x * a) by (apply Rmult_lt_0_compat; lra).
assert (Hxa' : x * a < e).
{ replace (pos e) with (x * (e / x)) by (field; lra). apply Rmult_lt_compat_l; lra. }
assert (Hxd : m < x * d).
{ replace m with (x * (m / x)) by (field; lra). apply Rmult_lt_compat_l; lra. }
destruct (HQS (x * a) (x * d)) as [z [Hz1 Hz2]]; simpl in *.
{ apply HQ; auto. apply Rabs_def1; unfold minus, plus, opp; simpl; lra. }
{ apply HS, Hxd. }
exists (C * z). split.
- rewrite <- (Rplus_0_r (x * a)), <- (Rplus_0_r (x * d)) in Hz1.
  apply (is_RInt_comp_lin (gamma_integrand s) x 0 a d) in Hz1.
  apply (is_RInt_scal _ _ _ C) in Hz1.
  eapply is_RInt_ext; [|exact Hz1].
  intros r Hr. rewrite Rmin_left in Hr by lra.
  change (C * (x * (Rpower (x * r + 0) (s - 1) * exp (- (x * r + 0))))
    = Rpower r (s - 1) * exp (- (x * r))).
  rewrite Rplus_0_r. rewrite <- Rpower_mult_distr by lra.
  replace (C * (x * (Rpower x (s - 1) * Rpower r (s - 1) * exp (- (x * r)))))
    with ((C * (x * Rpower x (s - 1))) * (Rpower r (s - 1) * exp (- (x * r)))) by ring.
  rewrite <- Rpower_S by lra. unfold C. rewrite <- Rpower_plus.
  replace (- s + (s - 1 + 1)) with 0 by ring. rewrite Rpower_O by lra. ring.
- unfold ball in *; simpl in *; unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
  replace (C * z + - (C * Gamma s)) with (C * (z + - Gamma s)) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq C) by lra.
  replace (pos eps) with (C * (eps / C)) by (field; lra).
  apply Rmult_lt_compat_l; auto.
Qed.

(** substitution r = x rho in an improper integral *)
Lemma improper_scale (f : R -> R) (x l : R) : 0 < x ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l ->
  is_RInt_gen (fun r => x * f (x * r)) (at_right 0) (Rbar_locally p_infty) l.
Proof.
intros Hx HG. unfold is_RInt_gen in *.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in HG |- *.
intros eps.
destruct (HG eps) as [Q S [d0 HQ] [m HS] HQS].
assert (Hex : 0 < d0 / x) by (apply Rdiv_lt_0_compat; auto; apply cond_pos).
generalize (trunc_and _ _ trunc_basic (trunc_smaller (d0 / x) (m / x) Hex)).
apply trunc_imp. intros [a d]; simpl; intros [[H1 H2] [H3 H4]].
assert (Hxa : 0 < x * a) by (apply Rmult_lt_0_compat; lra).
assert (Hxa' : x * a < d0).
{ replace (pos d0) with (x * (d0 / x)) by (field; lra). apply Rmult_lt_compat_l; lra. }
assert (Hxd : m < x * d).
{ replace m with (x * (m / x)) by (field; lra). apply Rmult_lt_compat_l; lra. }
destruct (HQS (x * a) (x * d)) as [z [Hz1 Hz2]]; simpl in *.
{ apply HQ; auto. apply Rabs_def1; unfold minus, plus, opp; simpl; lra. }
{ apply HS, Hxd. }
exists z. split; auto.
rewrite <- (Rplus_0_r (x * a)), <- (Rplus_0_r (x * d)) in Hz1.
apply (is_RInt_comp_lin f x 0 a d) in Hz1.
eapply is_RInt_ext; [|exact Hz1].
intros r Hr. change (x * f (x * r + 0) = x * f (x * r)). rewrite Rplus_0_r. reflexivity.
Qed.

(** ** A Laplace integral is convex, hence continuous, in the exponent *)
Lemma exp_convex l u v : 0 <= l <= 1 -> exp (l * u + (1 - l) * v) <= l * exp u + (1 - l) * exp v.
Proof.
intros Hl. set (m := l * u + (1 - l) * v).
assert (H : forall x, exp m * (1 + (x - m)) <= exp x).
{ intros x. replace (exp x) with (exp m * exp (x - m)) by (rewrite <- exp_plus; f_equal; ring).
  apply Rmult_le_compat_l; [apply Rlt_le, exp_pos|apply exp_ineq1_le]. }
assert (Hu := Rmult_le_compat_l l _ _ (proj1 Hl) (H u)).
assert (Hv := Rmult_le_compat_l (1 - l) _ _ ltac:(lra) (H v)).
replace (exp m) with (l * (exp m * (1 + (u - m))) + (1 - l) * (exp m * (1 + (v - m)))) by (unfold m; ring).
lra.
Qed.

Lemma improper_le (f g : R -> R) lf lg :
  (forall r, 0 < r -> f r <= g r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) lf ->
  is_RInt_gen g (at_right 0) (Rbar_locally p_infty) lg -> lf <= lg.
Proof.
intros Hfg Hf Hg.
assert (H := is_RInt_gen_minus _ _ _ _ Hg Hf).
assert (H0 := improper_pos _ _ (fun r Hr => proj1 (Rminus_le_0 _ _) (Hfg r Hr)) H).
apply Rminus_le_0. exact H0.
Qed.
