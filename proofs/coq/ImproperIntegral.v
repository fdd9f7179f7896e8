(** * Improper integrals on (0, oo)

    Equality and inequalities of integrands, substitution r = x rho, int r^(s-1) e^(-xr) dr = Gamma(s) x^(-s), and:
    int r^c w(r) dr is convex in c, hence continuous. *)

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

Lemma integral_convex (w G : R -> R) :
  (forall r, 0 < r -> 0 <= w r) ->
  (forall c, -1 < c -> is_RInt_gen (fun r => Rpower r c * w r) (at_right 0) (Rbar_locally p_infty) (G c)) ->
  forall l a b, 0 <= l <= 1 -> -1 < a -> -1 < b -> G (l * a + (1 - l) * b) <= l * G a + (1 - l) * G b.
Proof.
intros Hw HG l a b Hl Ha Hb.
assert (Hab : -1 < l * a + (1 - l) * b).
{ assert (0 <= l * (a - -1)) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - l) * (b - -1)) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec l (1 / 2)).
  - assert (0 < (1 - l) * (b - -1)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < l * (a - -1)) by (apply Rmult_lt_0_compat; lra). lra. }
apply (improper_le (fun r => Rpower r (l * a + (1 - l) * b) * w r)
  (fun r => plus (scal l (Rpower r a * w r)) (scal (1 - l) (Rpower r b * w r)))).
- intros r Hr. unfold plus, scal; simpl; unfold mult; simpl.
  replace (l * (Rpower r a * w r) + (1 - l) * (Rpower r b * w r))
    with ((l * Rpower r a + (1 - l) * Rpower r b) * w r) by ring.
  apply Rmult_le_compat_r; auto. unfold Rpower.
  replace ((l * a + (1 - l) * b) * ln r) with (l * (a * ln r) + (1 - l) * (b * ln r)) by ring.
  apply exp_convex, Hl.
- apply HG, Hab.
- assert (H1 := is_RInt_gen_scal _ l _ (HG a Ha)).
  assert (H2 := is_RInt_gen_scal _ (1 - l) _ (HG b Hb)).
  exact (is_RInt_gen_plus _ _ _ _ H1 H2).
Qed.

Lemma convex_continuous (G : R -> R) (lo : R) :
  (forall l a b, 0 <= l <= 1 -> lo < a -> lo < b -> G (l * a + (1 - l) * b) <= l * G a + (1 - l) * G b) ->
  forall c, lo < c -> is_lim G c (G c).
Proof.
intros HC c Hc.
set (d := (c - lo) / 2). assert (Hd : 0 < d) by (unfold d; lra).
set (B := Rabs (G (c + d) - G c) + Rabs (G c - G (c - d)) + 1).
assert (HB1 := Rabs_pos (G (c + d) - G c)). assert (HB2 := Rabs_pos (G c - G (c - d))).
assert (HB : 0 < B) by (unfold B; lra).
(* both sides at once: e = d or e = -d *)
assert (Hside : forall e l, (e = d \/ e = - d) -> 0 <= l <= 1 -> Rabs (G (c + l * e) - G c) <= l * B).
{ intros e l He Hl.
  assert (Hed : - d <= e <= d) by (destruct He; lra).
  assert (Hle : - d <= l * e <= d) by nra.
  assert (U := HC l (c + e) c Hl ltac:(unfold d in *; lra) Hc).
  replace (l * (c + e) + (1 - l) * c) with (c + l * e) in U by ring.
  assert (Hk : 0 <= / (1 + l) <= 1).
  { split. apply Rlt_le, Rinv_0_lt_compat; lra. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (L := HC (/ (1 + l)) (c + l * e) (c - e) Hk ltac:(unfold d in *; lra) ltac:(unfold d in *; lra)).
  replace (/ (1 + l) * (c + l * e) + (1 - / (1 + l)) * (c - e)) with c in L by (field; lra).
  apply (Rmult_le_compat_l (1 + l)) in L; [|lra].
  replace ((1 + l) * (/ (1 + l) * G (c + l * e) + (1 - / (1 + l)) * G (c - e)))
    with (G (c + l * e) + l * G (c - e)) in L by (field; lra).
  assert (Hp : G (c + e) - G c <= B /\ - (G (c - e) - G c) >= - B).
  { assert (A1 := Rle_abs (G (c + d) - G c)). assert (A2 := Rle_abs (- (G (c + d) - G c))).
    assert (A3 := Rle_abs (G c - G (c - d))). assert (A4 := Rle_abs (- (G c - G (c - d)))).
    rewrite Rabs_Ropp in A2, A4.
    destruct He as [->| ->].
    - unfold B. split; lra.
    - replace (c + - d) with (c - d) by ring. replace (c - - d) with (c + d) by ring. unfold B. split; lra. }
  destruct Hp as [P1 P2].
  assert (Q1 : l * (G (c + e) - G c) <= l * B) by (apply Rmult_le_compat_l; lra).
  assert (Q2 : l * (G (c - e) - G c) <= l * B) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le. lra. }
apply is_lim_spec. intros eps.
assert (Heps := cond_pos eps).
assert (Hdel : 0 < Rmin d (d * eps / B)).
{ apply Rmin_pos; auto. apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. }
enough (Hmain : forall y : R, Rabs (y + - c) < Rmin d (d * eps / B) -> Rabs (G y - G c) < eps)
  by (exists (mkposreal _ Hdel); intros y Hy _; apply (Hmain y Hy)).
intros y Hy.
assert (Hy1 := Rlt_le_trans _ _ _ Hy (Rmin_l _ _)). assert (Hy2 := Rlt_le_trans _ _ _ Hy (Rmin_r _ _)).
set (l := Rabs (y + - c) / d).
assert (Hl : 0 <= l <= 1).
{ unfold l. split. apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hd.
  apply Rmult_le_reg_r with d; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
assert (HlB : l * B < eps).
{ unfold l. apply Rmult_lt_reg_r with (d / B). apply Rdiv_lt_0_compat; auto.
  replace (Rabs (y + - c) / d * B * (d / B)) with (Rabs (y + - c)) by (field; lra).
  replace (eps * (d / B)) with (d * eps / B) by (field; lra). exact Hy2. }
destruct (Rle_lt_dec 0 (y + - c)) as [Hs|Hs].
- assert (E : y = c + l * d) by (unfold l; rewrite Rabs_pos_eq by auto; field; lra).
  rewrite E. eapply Rle_lt_trans; [apply (Hside d l); auto|exact HlB].
- assert (E : y = c + l * - d) by (unfold l; rewrite Rabs_left by auto; field; lra).
  rewrite E. eapply Rle_lt_trans; [apply (Hside (- d) l); auto|exact HlB].
Qed.

Lemma is_lim_shift (f : R -> R) (x a l : R) : is_lim f (x - a) l -> is_lim (fun y => f (y - a)) x l.
Proof.
intros H. apply is_lim_spec. apply is_lim_spec in H. intros eps.
destruct (H eps) as [d Hd]. exists d. intros y Hy Hne. apply Hd; [|lra].
unfold ball in *; simpl in *; unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
replace (y - a + - (x - a)) with (y + - x) by ring. exact Hy.
Qed.

Lemma is_lim_reflect (f : R -> R) (x l : R) : is_lim f (- x) l -> is_lim (fun y => f (- y)) x l.
Proof.
intros H. apply is_lim_spec. apply is_lim_spec in H. intros eps.
destruct (H eps) as [d Hd]. exists d. intros y Hy Hne. apply Hd; [|lra].
unfold ball in *; simpl in *; unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
replace (- y + - - x) with (- (y + - x)) by ring. rewrite Rabs_Ropp. exact Hy.
Qed.
