(** * The energy estimate

    For y''' = t y' + k y + g the energy y^2 + y'^2 + y''^2 grows at most exponentially on |t| <= T. Used for
    uniqueness, and to pass to the limit of the truncated integrals. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Open Scope R_scope.

Section Gronwall.
Variables (u0 u1 u2 g : R -> R) (k T eta : R).
Hypothesis HT : 0 <= T.
Hypothesis D0 : forall t, is_derive u0 t (u1 t).
Hypothesis D1 : forall t, is_derive u1 t (u2 t).
Hypothesis D2 : forall t, is_derive u2 t (t * u1 t + k * u0 t + g t).
Hypothesis Hg : forall t, Rabs t <= T -> Rabs (g t) <= eta.
Let E t := u0 t ^ 2 + u1 t ^ 2 + u2 t ^ 2.
Let E' t := 2 * u0 t * u1 t + 2 * u1 t * u2 t
            + 2 * u2 t * (t * u1 t + k * u0 t + g t).

Let K := 3 + T + Rabs k.

Lemma E_derive t : is_derive E t (E' t).
Proof.
unfold E, E'.
evar_last.
- apply (is_derive_plus (fun t => u0 t ^ 2 + u1 t ^ 2) (fun t => u2 t ^ 2)).
  apply (is_derive_plus (fun t => u0 t ^ 2) (fun t => u1 t ^ 2)).
  apply is_derive_pow, D0. apply is_derive_pow, D1. apply is_derive_pow, D2.
- unfold plus; simpl; ring.
Qed.

Lemma two_ab (a b : R) : Rabs (2 * a * b) <= a ^ 2 + b ^ 2.
Proof.
generalize (pow2_ge_0 (a + b)) (pow2_ge_0 (a - b)).
unfold Rabs; destruct Rcase_abs; intros; lra.
Qed.

Lemma prod_ab (a b m B : R) : Rabs m <= B -> Rabs (m * (2 * a * b)) <= B * (a ^ 2 + b ^ 2).
Proof.
intros H; rewrite Rabs_mult.
apply Rmult_le_compat; auto using Rabs_pos, two_ab.
Qed.

Lemma E'_bound t : Rabs t <= T -> Rabs (E' t) <= K * (E t + eta ^ 2).
Proof.
intros Ht.
specialize (Hg t Ht).
assert (He : 0 <= eta) by (generalize (Rabs_pos (g t)); lra).
assert (Hg2 : g t ^ 2 <= eta ^ 2).
{ rewrite <- (Rabs_pos_eq (g t ^ 2)) by nra.
  rewrite <- RPow_abs. apply pow_incr; split; auto using Rabs_pos. }
unfold E'.
generalize (two_ab (u0 t) (u1 t)) (two_ab (u1 t) (u2 t))
  (prod_ab (u2 t) (u1 t) t T Ht) (prod_ab (u2 t) (u0 t) k (Rabs k) (Rle_refl _))
  (two_ab (u2 t) (g t)).
replace (2 * u0 t * u1 t + 2 * u1 t * u2 t + 2 * u2 t * (t * u1 t + k * u0 t + g t))
  with (2 * u0 t * u1 t + 2 * u1 t * u2 t + t * (2 * u2 t * u1 t)
        + k * (2 * u2 t * u0 t) + 2 * u2 t * g t) by ring.
intros H1 H2 H3 H4 H5.
eapply Rle_trans. apply Rabs_triang.
eapply Rle_trans. apply Rplus_le_compat_r. apply Rabs_triang.
eapply Rle_trans. apply Rplus_le_compat_r. apply Rplus_le_compat_r. apply Rabs_triang.
eapply Rle_trans. do 3 apply Rplus_le_compat_r. apply Rabs_triang.
unfold K, E.
generalize (Rabs_pos k); intros Hk.
generalize (pow2_ge_0 (u0 t)) (pow2_ge_0 (u1 t)) (pow2_ge_0 (u2 t)) (pow2_ge_0 eta).
revert H1 H2 H3 H4 H5 Hk Hg2.
generalize (u0 t ^ 2) (u1 t ^ 2) (u2 t ^ 2) (g t ^ 2) (eta ^ 2) (Rabs k).
intros a b c d e kk. intros.
assert (0 <= T * a) by now apply Rmult_le_pos.
assert (0 <= T * b) by now apply Rmult_le_pos.
assert (0 <= T * c) by now apply Rmult_le_pos.
assert (0 <= T * e) by now apply Rmult_le_pos.
assert (0 <= kk * a) by now apply Rmult_le_pos.
assert (0 <= kk * b) by now apply Rmult_le_pos.
assert (0 <= kk * c) by now apply Rmult_le_pos.
assert (0 <= kk * e) by now apply Rmult_le_pos.
lra.
Qed.

Lemma gronwall t : Rabs t <= T ->
  E t <= (E 0 + eta ^ 2) * exp (K * T).
Proof.
intros Ht.
assert (HK : 0 <= K) by (unfold K; generalize (Rabs_pos k); lra).
assert (HE0 : 0 <= E 0 + eta ^ 2)
  by (unfold E; generalize (pow2_ge_0 (u0 0)) (pow2_ge_0 (u1 0)) (pow2_ge_0 (u2 0)) (pow2_ge_0 eta); lra).
assert (HexpT : (E 0 + eta ^ 2) * exp (K * Rabs t) <= (E 0 + eta ^ 2) * exp (K * T)).
{ apply Rmult_le_compat_l; auto.
  destruct (Rle_lt_or_eq_dec _ _ (Rmult_le_compat_l K _ _ HK Ht)) as [H|H].
  apply Rlt_le, exp_increasing, H. rewrite H; apply Rle_refl. }
enough (E t + eta ^ 2 <= (E 0 + eta ^ 2) * exp (K * Rabs t))
  by (generalize (pow2_ge_0 eta); lra).
destruct (Rle_lt_dec 0 t) as [H0|H0].
- rewrite (Rabs_pos_eq t) in * by auto.
  assert (H : (E t + eta ^ 2) * exp (- K * t) <= (E 0 + eta ^ 2) * exp (- K * 0)).
  { apply (decr_of_derive (fun s => (E s + eta ^ 2) * exp (- K * s))
       (fun s => (E' s - K * (E s + eta ^ 2)) * exp (- K * s)) 0 t H0).
    - intros s Hs.
      evar_last.
      apply (is_derive_mult_R (fun s => E s + eta ^ 2) (fun s => exp (- K * s)) s (E' s) (- K * exp (- K * s))).
      + evar_last. apply (is_derive_plus E (fun _ => eta ^ 2)).
        apply E_derive. apply (is_derive_const (eta ^ 2)).
        apply plus_zero_r.
      + auto_derive; auto; ring.
      + ring.
    - intros s Hs.
      assert (Rabs s <= T) by (rewrite Rabs_pos_eq; lra).
      generalize (E'_bound s H) (Rle_abs (E' s)) (exp_pos (- K * s)).
      intros. nra. }
  rewrite Rmult_0_r, exp_0, Rmult_1_r in H.
  replace (E t + eta ^ 2) with ((E t + eta ^ 2) * exp (- K * t) * exp (K * t)).
  apply Rmult_le_compat_r; auto. apply Rlt_le, exp_pos.
  rewrite Rmult_assoc, <- exp_plus.
  replace (- K * t + K * t) with 0 by ring. rewrite exp_0; ring.
- rewrite (Rabs_left t) in * by auto.
  assert (H : - ((E 0 + eta ^ 2) * exp (K * 0)) <= - ((E t + eta ^ 2) * exp (K * t))).
  { apply (decr_of_derive (fun s => - ((E s + eta ^ 2) * exp (K * s)))
       (fun s => - ((E' s + K * (E s + eta ^ 2)) * exp (K * s))) t 0 (Rlt_le _ _ H0)).
    - intros s Hs.
      evar_last.
      apply (is_derive_opp (fun s => (E s + eta ^ 2) * exp (K * s))).
      apply (is_derive_mult_R (fun s => E s + eta ^ 2) (fun s => exp (K * s)) s (E' s) (K * exp (K * s))).
      + evar_last. apply (is_derive_plus E (fun _ => eta ^ 2)).
        apply E_derive. apply (is_derive_const (eta ^ 2)).
        apply plus_zero_r.
      + auto_derive; auto; ring.
      + unfold opp; simpl; ring.
    - intros s Hs.
      assert (Rabs s <= T) by (rewrite Rabs_left1; lra).
      generalize (E'_bound s H) (Rle_abs (- E' s)) (exp_pos (K * s)).
      rewrite Rabs_Ropp.
      intros. nra. }
  rewrite Rmult_0_r, exp_0, Rmult_1_r in H.
  replace (E t + eta ^ 2) with ((E t + eta ^ 2) * exp (K * t) * exp (K * - t)).
  apply Rmult_le_compat_r. apply Rlt_le, exp_pos. lra.
  rewrite Rmult_assoc, <- exp_plus.
  replace (K * t + K * - t) with 0 by ring. rewrite exp_0; ring.
Qed.

Lemma gronwall_u0 t : Rabs t <= T ->
  u0 t ^ 2 <= (u0 0 ^ 2 + u1 0 ^ 2 + u2 0 ^ 2 + eta ^ 2) * exp ((3 + T + Rabs k) * T).
Proof.
intros Ht; generalize (gronwall t Ht).
unfold E, K.
generalize (pow2_ge_0 (u1 t)) (pow2_ge_0 (u2 t)); lra.
Qed.

End Gronwall.
