(** * The truncated Laplace integrals

    M s a d t = int_a^d r^s e^(rt - r^3/3) dr with 0 < a <= d: its derivative in t is M (s + 1); it satisfies the
    equation up to boundary terms, the total derivative of r^(s+1) e^(rt - r^3/3); it is positive, and grows with [a,
    d]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Open Scope R_scope.

Definition kernel (s t r : R) : R := Rpower r s * exp (r * t - r ^ 3 / 3).

Definition M (s a d t : R) : R := RInt (kernel s t) a d.

Lemma kernel_pos s t r : 0 < kernel s t r.
Proof. unfold kernel, Rpower; apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma continuous_kernel s t r : 0 < r -> continuous (kernel s t) r.
Proof.
intros Hr. apply (ex_derive_continuous (kernel s t) r).
unfold kernel, Rpower. auto_derive; auto.
Qed.

Lemma ex_RInt_kernel s t a d : 0 < a -> a <= d -> ex_RInt (kernel s t) a d.
Proof.
intros Ha Hd. apply (ex_RInt_continuous (kernel s t)).
intros z Hz; rewrite Rmin_left in Hz by lra.
apply continuous_kernel; lra.
Qed.

Lemma Rpower_S s r : 0 < r -> Rpower r (s + 1) = r * Rpower r s.
Proof.
intros Hr; rewrite Rpower_plus, Rpower_1 by exact Hr; ring.
Qed.

Lemma Derive_kernel s r t : 0 < r -> is_derive (fun t => kernel s t r) t (kernel (s + 1) t r).
Proof.
intros Hr; unfold kernel; rewrite Rpower_S by exact Hr.
generalize (r ^ 3 / 3) (Rpower r s); intros q p.
auto_derive; auto. unfold Rminus; ring.
Qed.

Lemma is_derive_M s a d t : 0 < a -> a <= d ->
  is_derive (M s a d) t (M (s + 1) a d t).
Proof.
intros Ha Hd.
assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
evar_last.
- apply (is_derive_RInt_param (fun t r => kernel s t r) a d t).
  + apply filter_forall. intros x r Hr; rewrite Hmin in Hr.
    exists (kernel (s + 1) x r). apply Derive_kernel; lra.
  + intros r Hr; rewrite Hmin in Hr.
    apply continuity_2d_pt_ext_loc with (f := fun u v => kernel (s + 1) u v).
    * assert (H0 : 0 < r) by lra.
      exists (mkposreal r H0). simpl.
      intros u v Hu Hv. symmetry. apply is_derive_unique, Derive_kernel.
      apply Rabs_def2 in Hv; lra.
    * unfold kernel.
      apply continuity_2d_pt_mult.
      -- apply (continuity_1d_2d_pt_comp (fun v => Rpower v (s + 1)) (fun u v => v)).
         apply continuity_pt_filterlim, (ex_derive_continuous (fun v => Rpower v (s + 1)) r).
         unfold Rpower; auto_derive; lra.
         apply continuity_2d_pt_id2.
      -- apply (continuity_1d_2d_pt_comp exp (fun u v => v * u - v ^ 3 / 3)).
         apply continuity_pt_filterlim, continuous_exp.
         apply continuity_2d_pt_minus.
         apply continuity_2d_pt_mult. apply continuity_2d_pt_id2. apply continuity_2d_pt_id1.
         apply (continuity_1d_2d_pt_comp (fun v => v ^ 3 / 3) (fun u v => v)).
         apply continuity_pt_filterlim, (ex_derive_continuous (fun v => v ^ 3 / 3) r).
         auto_derive; auto.
         apply continuity_2d_pt_id2.
  + apply filter_forall. intros x. apply ex_RInt_kernel; auto.
- unfold M. apply RInt_ext. intros r Hr; rewrite Hmin in Hr.
  apply is_derive_unique, Derive_kernel; lra.
Qed.

(** Total derivative: integrates to the perturbed ODE. *)

Lemma is_derive_kernel_r c t r : 0 < r ->
  is_derive (kernel (c + 1) t) r
    ((c + 1) * kernel c t r + t * kernel (c + 1) t r - kernel (c + 3) t r).
Proof.
intros Hr.
replace (c + 3) with (c + 1 + 1 + 1) by ring.
unfold kernel. rewrite !(Rpower_S _ r Hr).
evar_last.
- apply (is_derive_mult_R (fun r => Rpower r (c + 1)) (fun r => exp (r * t - r ^ 3 / 3)) r
    ((c + 1) * Rpower r c) ((t - r ^ 2) * exp (r * t - r ^ 3 / 3))).
  + unfold Rpower. auto_derive; auto.
    replace (exp ((c + 1) * ln r)) with (r * exp (c * ln r)).
    field; lra.
    fold (Rpower r c) (Rpower r (c + 1)). rewrite Rpower_S by auto; ring.
  + evar_last.
    apply (is_derive_comp exp (fun r => r * t - r ^ 3 / 3) r
      (exp (r * t - r ^ 3 / 3)) (t - r ^ 2)).
    apply is_derive_exp.
    auto_derive; auto; field.
    reflexivity.
- rewrite !(Rpower_S _ r Hr). field.
Qed.

Lemma M_ode c a d t : 0 < a -> a <= d ->
  M (c + 3) a d t =
  t * M (c + 1) a d t + (c + 1) * M c a d t
  + (kernel (c + 1) t a - kernel (c + 1) t d).
Proof.
intros Ha Hd.
assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
assert (H : is_RInt (fun r => (c + 1) * kernel c t r + t * kernel (c + 1) t r - kernel (c + 3) t r) a d
   (kernel (c + 1) t d - kernel (c + 1) t a)).
{ apply (is_RInt_derive (kernel (c + 1) t)).
  - intros r Hr; rewrite Hmin in Hr. apply is_derive_kernel_r; lra.
  - intros r Hr; rewrite Hmin in Hr.
    assert (H0 : 0 < r) by lra.
    apply (continuous_minus (fun r => (c + 1) * kernel c t r + t * kernel (c + 1) t r) (kernel (c + 3) t)).
    apply (continuous_plus (fun r => (c + 1) * kernel c t r) (fun r => t * kernel (c + 1) t r)).
    apply (continuous_scal_r (c + 1) (kernel c t)), continuous_kernel, H0.
    apply (continuous_scal_r t (kernel (c + 1) t)), continuous_kernel, H0.
    apply continuous_kernel, H0. }
apply (is_RInt_unique (V := R_CompleteNormedModule)) in H.
assert (H2 : is_RInt (fun r => (c + 1) * kernel c t r + t * kernel (c + 1) t r - kernel (c + 3) t r) a d
   ((c + 1) * M c a d t + t * M (c + 1) a d t - M (c + 3) a d t)).
{ apply (is_RInt_minus (fun r => (c + 1) * kernel c t r + t * kernel (c + 1) t r) (kernel (c + 3) t)).
  apply (is_RInt_plus (fun r => (c + 1) * kernel c t r) (fun r => t * kernel (c + 1) t r)).
  apply (is_RInt_scal (kernel c t)). apply (RInt_correct (kernel c t)), ex_RInt_kernel; auto.
  apply (is_RInt_scal (kernel (c + 1) t)). apply (RInt_correct (kernel (c + 1) t)), ex_RInt_kernel; auto.
  apply (RInt_correct (kernel (c + 3) t)), ex_RInt_kernel; auto. }
apply (is_RInt_unique (V := R_CompleteNormedModule)) in H2.
rewrite H in H2. lra.
Qed.

(** Monotonicity in the truncation, and positivity. *)

Lemma M_pos s a d t : 0 < a -> a < d -> 0 < M s a d t.
Proof.
intros Ha Hd; apply RInt_gt_0; auto.
- intros; apply kernel_pos.
- intros; apply continuous_kernel; lra.
Qed.

Lemma M_mono s a d a' d' t : 0 < a -> a <= a' -> a' <= d' -> d' <= d ->
  M s a' d' t <= M s a d t.
Proof.
intros H1 H2 H3 H4.
unfold M.
rewrite <- (RInt_Chasles (kernel s t) a a' d) by (apply ex_RInt_kernel; lra).
rewrite <- (RInt_Chasles (kernel s t) a' d' d) by (apply ex_RInt_kernel; lra).
assert (0 <= RInt (kernel s t) a a').
{ apply RInt_ge_0; try lra. apply ex_RInt_kernel; lra. intros; apply Rlt_le, kernel_pos. }
assert (0 <= RInt (kernel s t) d' d).
{ apply RInt_ge_0; try lra. apply ex_RInt_kernel; lra. intros; apply Rlt_le, kernel_pos. }
unfold plus; simpl. lra.
Qed.
