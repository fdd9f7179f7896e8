(** * Theta as a Laplace integral; impact without collision at leading order

    Gamma(-b) Theta^(n) solves the equation with c = n - b - 1 and has the data of its integral: so for n > b it is the
    integral, and positive. For 0 < b < 1 Gamma(-b) < 0, and so dTheta/dtau < 0 on the whole line. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit IntegralSolution GammaFunction.
Open Scope R_scope.

(** [Laplace c y]: y solves y''' = t y' + (c+1) y with the initial values of
    int_0^oo r^c exp(r t - r^3/3) dr. *)
Definition Laplace (c : R) (y : R -> R) : Prop :=
  exists y1 y2 : R -> R,
  (forall t, is_derive y t (y1 t)) /\
  (forall t, is_derive y1 t (y2 t)) /\
  (forall t, is_derive y2 t (t * y1 t + (c + 1) * y t)) /\
  y 0 = Rpower 3 ((c - 2) / 3) * Gamma ((c + 1) / 3) /\
  y1 0 = Rpower 3 ((c - 1) / 3) * Gamma ((c + 2) / 3) /\
  y2 0 = Rpower 3 (c / 3) * Gamma ((c + 3) / 3).

Lemma Laplace_ext c y z : (forall t, y t = z t) -> Laplace c y -> Laplace c z.
Proof.
intros E (y1 & y2 & D0 & D1 & D2 & I0 & I1 & I2).
exists y1, y2.
refine (conj _ (conj D1 (conj _ (conj _ (conj I1 I2))))).
- intros t. apply (is_derive_ext y); auto.
- intros t. rewrite <- E; auto.
- rewrite <- E; auto.
Qed.

Lemma Laplace_representation c y : -1 < c -> Laplace c y -> forall t,
  is_RInt_gen (fun r => Rpower r c * exp (r * t - r ^ 3 / 3))
    (at_right 0) (Rbar_locally p_infty) (y t).
Proof.
intros Hc (y1 & y2 & D0 & D1 & D2 & I0 & I1 & I2) t.
exact (representation c _ _ _ Hc (Gamma_is ((c + 1) / 3) ltac:(lra))
  (Gamma_is ((c + 2) / 3) ltac:(lra)) (Gamma_is ((c + 3) / 3) ltac:(lra))
  y y1 y2 D0 D1 D2 I0 I1 I2 t).
Qed.

Lemma Laplace_lower_bound c y : -1 < c -> Laplace c y -> forall t,
  RInt (fun r => Rpower r c * exp (r * t - r ^ 3 / 3)) 1 2 <= y t.
Proof.
intros Hc (y1 & y2 & D0 & D1 & D2 & I0 & I1 & I2) t.
exact (lower_bound c _ _ _ Hc (Gamma_is ((c + 1) / 3) ltac:(lra))
  (Gamma_is ((c + 2) / 3) ltac:(lra)) (Gamma_is ((c + 3) / 3) ltac:(lra))
  y y1 y2 D0 D1 D2 I0 I1 I2 t).
Qed.

Lemma Laplace_pos c y : -1 < c -> Laplace c y -> forall t, 0 < y t.
Proof.
intros Hc H t. eapply Rlt_le_trans; [|apply (Laplace_lower_bound c y Hc H t)].
apply (M_pos c 1 2 t); lra.
Qed.

(** The derivative of a [Laplace c] function is a [Laplace (c+1)] function. *)
Lemma Laplace_derive c y : c <> -1 -> Laplace c y -> Laplace (c + 1) (Derive y).
Proof.
intros Hc (y1 & y2 & D0 & D1 & D2 & I0 & I1 & I2).
apply Laplace_ext with y1.
{ intros t; symmetry; apply is_derive_unique, D0. }
exists y2, (fun t => t * y1 t + (c + 1) * y t).
assert (E : c + 1 + 1 = c + 2) by ring.
refine (conj D1 (conj D2 (conj _ (conj _ (conj _ _))))).
- intros t. evar_last.
  + apply (is_derive_plus (fun t => t * y1 t) (fun t => (c + 1) * y t)).
    apply (is_derive_mult_R (fun t => t) y1). apply (is_derive_id t). apply D1.
    apply (is_derive_scal y). apply D0.
  + unfold plus, one; simpl. ring.
- rewrite E. replace (c + 1 - 2) with (c - 1) by ring. exact I1.
- replace (c + 1 - 1) with c by ring. replace (c + 1 + 2) with (c + 3) by ring. exact I2.
- rewrite I0.
  replace ((c + 1 + 3) / 3) with ((c + 1) / 3 + 1) by field.
  rewrite Gamma_rec by lra.
  replace ((c + 1) / 3) with (1 + (c - 2) / 3) at 2 by field.
  rewrite Rpower_plus, Rpower_1 by lra. field.
Qed.

Lemma Laplace_derive_n c y n :
  (forall k, (k < n)%nat -> c + INR k <> -1) ->
  Laplace c y -> Laplace (c + INR n) (Derive_n y n).
Proof.
intros Hc H; induction n as [|n IH].
- simpl. rewrite Rplus_0_r. exact H.
- rewrite S_INR, <- Rplus_assoc. apply (Laplace_derive (c + INR n) (Derive_n y n)).
  apply Hc; lia. apply IH. intros k Hk; apply Hc; lia.
Qed.

Lemma Rpower3_inv x y : x + y = 0 -> / Rpower 3 x = Rpower 3 y.
Proof. intros H. rewrite <- Rpower_Ropp. f_equal; lra. Qed.

Lemma not_nat_01 b : 0 < b < 1 -> not_nat b.
Proof.
intros Hb [|n] ->. simpl in Hb; lra.
rewrite S_INR in Hb. generalize (pos_INR n); lra.
Qed.

Lemma not_nat_neg b : b < 0 -> not_nat b.
Proof. intros Hb n ->. generalize (pos_INR n); lra. Qed.

(** The reduction: Gamma(-b) Theta is a [Laplace (-b-1)] function. *)
Theorem Theta_Laplace (b : R) (theta : R -> R) :
  not_nat b -> is_Theta b theta ->
  Laplace (- b - 1) (fun t => Gamma (- b) * theta t).
Proof.
intros Hb (Hex & Hode & H0 & H1 & H2).
assert (Hg : Gamma (- b) <> 0).
{ apply Gamma_neq0. intros n Hn; apply (Hb n); lra. }
set (g := Gamma (- b)) in *.
assert (D : forall n t, (n < 3)%nat ->
  is_derive (Derive_n theta n) t (Derive_n theta (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n theta n)).
  exact (Hex (S n) t Hn). }
exists (fun t => g * Derive theta t), (fun t => g * Derive_n theta 2 t).
assert (Hnz : forall x, Rpower 3 x <> 0) by (intros x; apply Rgt_not_eq, exp_pos).
refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))).
- intros t. apply (is_derive_scal theta t g (Derive theta t)).
  apply (D 0%nat t); lia.
- intros t. apply (is_derive_scal (Derive_n theta 1) t g (Derive_n theta 2 t)).
  apply (D 1%nat t); lia.
- intros t.
  replace (t * (g * Derive theta t) + (- b - 1 + 1) * (g * theta t))
   with (g * Derive_n theta 3 t)
   by (replace (Derive_n theta 3 t) with (t * Derive theta t - b * theta t)
         by (generalize (Hode t); lra); ring).
  apply (is_derive_scal (Derive_n theta 2) t g (Derive_n theta 3 t)).
  apply (D 2%nat t); lia.
- rewrite H0.
  rewrite <- (Rpower3_inv ((3 + b) / 3) ((- b - 1 - 2) / 3)) by field.
  replace ((- b - 1 + 1) / 3) with (- b / 3) by field.
  field; auto.
- rewrite H1.
  rewrite <- (Rpower3_inv ((2 + b) / 3) ((- b - 1 - 1) / 3)) by field.
  replace ((- b - 1 + 2) / 3) with ((1 - b) / 3) by field.
  field; auto.
- rewrite H2.
  rewrite <- (Rpower3_inv ((1 + b) / 3) ((- b - 1) / 3)) by field.
  replace ((- b - 1 + 3) / 3) with ((2 - b) / 3) by field.
  field; auto.
Qed.

Theorem Theta_Laplace_n (b : R) (theta : R -> R) (n : nat) :
  not_nat b -> is_Theta b theta ->
  Laplace (INR n - b - 1) (fun t => Gamma (- b) * Derive_n theta n t).
Proof.
intros Hb H.
apply (Laplace_ext _ (Derive_n (fun t => Gamma (- b) * theta t) n)).
- intros t. apply Derive_n_scal_l.
- replace (INR n - b - 1) with (- b - 1 + INR n) by ring.
  apply Laplace_derive_n.
  + intros k _ Hk. apply (Hb k); lra.
  + apply Theta_Laplace; auto.
Qed.

(** Integral representation of the n-th derivative, n > b. *)
Theorem Theta_representation (b : R) (theta : R -> R) (n : nat) :
  not_nat b -> b < INR n -> is_Theta b theta -> forall t,
  is_RInt_gen (fun r => Rpower r (INR n - b - 1) * exp (r * t - r ^ 3 / 3))
    (at_right 0) (Rbar_locally p_infty) (Gamma (- b) * Derive_n theta n t).
Proof.
intros Hb Hn H t.
apply (Laplace_representation (INR n - b - 1) (fun t => Gamma (- b) * Derive_n theta n t)); [lra|].
apply Theta_Laplace_n; auto.
Qed.

(** Sign of the n-th derivative, for every n > b. *)
Theorem Theta_sign (b : R) (theta : R -> R) (n : nat) :
  not_nat b -> b < INR n -> is_Theta b theta ->
  forall t, 0 < Gamma (- b) * Derive_n theta n t.
Proof.
intros Hb Hn H t.
apply (Laplace_pos (INR n - b - 1) (fun t => Gamma (- b) * Derive_n theta n t)); [lra|].
apply Theta_Laplace_n; auto.
Qed.

(** All derivatives of order n >= 1 are negative for 0 < b < 1. *)
Theorem IWC_all (b : R) (theta : R -> R) :
  0 < b < 1 -> is_Theta b theta -> forall n t, (1 <= n)%nat -> Derive_n theta n t < 0.
Proof.
intros Hb H n t Hn.
apply neg_of_prod_pos with (Gamma (- b)). apply Gamma_neg, Hb.
apply Theta_sign; auto. apply not_nat_01, Hb.
apply (le_INR 1) in Hn. simpl in Hn. lra.
Qed.

(** The IWC conjecture. *)
Theorem IWC (b : R) (theta : R -> R) :
  0 < b < 1 -> is_Theta b theta -> forall t, Derive theta t < 0.
Proof. intros Hb H t. apply (IWC_all b theta Hb H 1 t); lia. Qed.

(** b < 0: Theta and all its derivatives are positive. *)
Theorem Theta_pos_b_neg (b : R) (theta : R -> R) :
  b < 0 -> is_Theta b theta -> forall n t, 0 < Derive_n theta n t.
Proof.
intros Hb H n t.
apply pos_of_prod_pos with (Gamma (- b)). apply Gamma_pos; lra.
apply Theta_sign; auto. apply not_nat_neg, Hb.
generalize (pos_INR n); lra.
Qed.
