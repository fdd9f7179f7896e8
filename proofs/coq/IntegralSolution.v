(** * The solution with these data is the improper integral

    y''' = t y' + (c + 1) y with the data that the integral int_0^oo r^c e^(rt - r^3/3) dr has at t = 0: by the energy
    estimate y is within any eta of the truncated integrals. No improper integral is ever differentiated. Hence y is
    positive. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus Gronwall TruncatedIntegral TruncationLimit.
Open Scope R_scope.

Section Core.
Variables (c G0 G1 G2 : R).
Hypothesis Hc : -1 < c.
Hypothesis HG0 : is_GammaInt ((c + 1) / 3) G0.
Hypothesis HG1 : is_GammaInt ((c + 2) / 3) G1.
Hypothesis HG2 : is_GammaInt ((c + 3) / 3) G2.
Variables (y0 y1 y2 : R -> R).
Hypothesis Y0 : forall t, is_derive y0 t (y1 t).
Hypothesis Y1 : forall t, is_derive y1 t (y2 t).
Hypothesis Y2 : forall t, is_derive y2 t (t * y1 t + (c + 1) * y0 t).
Hypothesis I0 : y0 0 = Rpower 3 ((c - 2) / 3) * G0.
Hypothesis I1 : y1 0 = Rpower 3 ((c - 1) / 3) * G1.
Hypothesis I2 : y2 0 = Rpower 3 (c / 3) * G2.

Lemma trunc_error (a d t eta : R) :
  0 < a -> a <= d ->
  Rabs (M c a d 0 - y0 0) <= eta ->
  Rabs (M (c + 1) a d 0 - y1 0) <= eta ->
  Rabs (M (c + 2) a d 0 - y2 0) <= eta ->
  (forall s, Rabs s <= Rabs t -> Rabs (kernel (c + 1) s a - kernel (c + 1) s d) <= eta) ->
  (M c a d t - y0 t) ^ 2 <=
    4 * eta ^ 2 * exp ((3 + Rabs t + Rabs (c + 1)) * Rabs t).
Proof.
intros Ha Hd H0 H1 H2 Hb.
eapply Rle_trans.
apply (gronwall_u0 (fun s => M c a d s - y0 s) (fun s => M (c + 1) a d s - y1 s)
  (fun s => M (c + 2) a d s - y2 s) (fun s => kernel (c + 1) s a - kernel (c + 1) s d)
  (c + 1) (Rabs t) eta (Rabs_pos t)).
- intros s. apply (is_derive_minus (M c a d) y0 s (M (c + 1) a d s) (y1 s)); auto.
  apply is_derive_M; auto.
- intros s. apply (is_derive_minus (M (c + 1) a d) y1 s (M (c + 2) a d s) (y2 s)); auto.
  replace (c + 2) with (c + 1 + 1) by ring.
  apply is_derive_M; auto.
- intros s.
  replace (s * (M (c + 1) a d s - y1 s) + (c + 1) * (M c a d s - y0 s) +
     (kernel (c + 1) s a - kernel (c + 1) s d))
   with (M (c + 3) a d s - (s * y1 s + (c + 1) * y0 s))
   by (rewrite M_ode by auto; ring).
  apply (is_derive_minus (M (c + 2) a d) y2 s (M (c + 3) a d s)
     (s * y1 s + (c + 1) * y0 s)); auto.
  replace (c + 3) with (c + 2 + 1) by ring.
  apply is_derive_M; auto.
- exact Hb.
- apply Rle_refl.
- apply Rmult_le_compat_r. apply Rlt_le, exp_pos.
  assert (Hsq : forall x, Rabs x <= eta -> x ^ 2 <= eta ^ 2).
  { intros x Hx. rewrite <- (Rabs_pos_eq (x ^ 2)) by apply pow2_ge_0.
    rewrite <- RPow_abs. apply pow_incr; split; auto using Rabs_pos. }
  generalize (Hsq _ H0) (Hsq _ H1) (Hsq _ H2). lra.
Qed.

Lemma M_lim t (eps : posreal) :
  trunc (fun ad => Rabs (M c (fst ad) (snd ad) t - y0 t) < eps).
Proof.
set (L := (3 + Rabs t + Rabs (c + 1)) * Rabs t).
set (eta := eps / 3 * exp (- L / 2)).
assert (He : 0 < eta).
{ apply Rmult_lt_0_compat. generalize (cond_pos eps); lra. apply exp_pos. }
assert (HG1' : is_GammaInt ((c + 1 + 1) / 3) G1)
  by (replace (c + 1 + 1) with (c + 2) by ring; auto).
assert (HG2' : is_GammaInt ((c + 2 + 1) / 3) G2)
  by (replace (c + 2 + 1) with (c + 3) by ring; auto).
generalize (trunc_and _ _ trunc_basic (trunc_and _ _
  (boundary_small (c + 1) (Rabs t) eta ltac:(lra) (Rabs_pos t) He)
  (trunc_and _ _ (M0_lim _ _ HG0 (mkposreal _ He))
  (trunc_and _ _ (M0_lim _ _ HG1' (mkposreal _ He)) (M0_lim _ _ HG2' (mkposreal _ He)))))).
apply trunc_imp.
intros [a d]; simpl; intros [[Ha Hd] [Hb [H0 [H1 H2]]]].
assert (Hle := trunc_error a d t eta ltac:(lra) ltac:(lra)).
rewrite I0, I1, I2 in Hle.
replace (c + 1 - 2) with (c - 1) in H1 by ring.
replace (c + 2 - 2) with c in H2 by ring.
specialize (Hle (Rlt_le _ _ H0) (Rlt_le _ _ H1) (Rlt_le _ _ H2) Hb).
fold L in Hle.
replace (4 * eta ^ 2 * exp L) with (4 / 9 * eps ^ 2) in Hle.
2: { unfold eta. replace (exp L) with (/ (exp (- L / 2)) ^ 2).
     field. apply Rgt_not_eq, exp_pos.
     rewrite <- Rpower_pow by apply exp_pos. unfold Rpower.
     rewrite ln_exp, <- exp_Ropp. f_equal. simpl; field. }
assert (Hp := cond_pos eps).
rewrite <- (Rabs_pos_eq eps) by lra.
apply Rsqr_lt_abs_0. unfold Rsqr.
assert (0 < eps * eps) by (apply Rmult_lt_0_compat; auto).
simpl in Hle. lra.
Qed.

(** The integral representation. *)
Theorem representation t :
  is_RInt_gen (kernel c t) (at_right 0) (Rbar_locally p_infty) (y0 t).
Proof.
unfold is_RInt_gen.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))).
intros eps.
generalize (trunc_and _ _ trunc_basic (M_lim t eps)).
apply trunc_imp. intros [a d]; simpl; intros [[Ha Hd] H].
exists (M c a d t). split.
- apply (RInt_correct (kernel c t)), ex_RInt_kernel; lra.
- exact H.
Qed.

(** Positivity, with an explicit lower bound. *)
Theorem lower_bound t : M c 1 2 t <= y0 t.
Proof.
apply Rnot_lt_le. intros Hlt.
assert (He : 0 < M c 1 2 t - y0 t) by lra.
destruct (filter_ex (F := trunc) _ (trunc_and _ _ trunc_basic (M_lim t (mkposreal _ He))))
  as [[a d] [[Ha Hd] H]].
simpl in *.
assert (M c 1 2 t <= M c a d t) by (apply M_mono; lra).
apply Rabs_def2 in H. lra.
Qed.

Theorem positivity t : 0 < y0 t.
Proof.
eapply Rlt_le_trans; [|apply lower_bound].
apply M_pos; lra.
Qed.

End Core.
