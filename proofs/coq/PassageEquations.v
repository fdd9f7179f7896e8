(** * The model system in good coordinates

    The Proposition of proofs/from_state.md, section 1, and (4) of section 3. Each derivative is taken with
    [auto_derive] from those of the state; what remains is an identity of rational functions. *)

From Coq Require Import Reals Psatz Lra List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus LogarithmicNorm StatementStep StatementPassage.
Open Scope R_scope.

Lemma derive_same (f f0 : R -> R) (t f1 f2 : R) : is_derive f t f1 -> (forall s, f s = f0 s) -> f1 = f2 ->
  is_derive f0 t f2.
Proof. intros D H <-. apply (is_derive_ext f); assumption. Qed.

Lemma kappa_positive M : contact_positive M -> 0 < kappa_of M.
Proof. intros (H1 & H2 & _). unfold kappa_of. apply Rdiv_lt_0_compat. apply Rmult_lt_0_compat; auto. lra. Qed.

Lemma g_positive M : contact_positive M -> 0 < g_of M.
Proof. intros (H1 & H2 & H3). unfold g_of. apply Rdiv_lt_0_compat; lra. Qed.

Lemma l_value M : contact_positive M -> l_of M = k2 M ^ 2 / (k1 M + k2 M).
Proof. intros (H1 & H2 & _). unfold l_of, kappa_of. field. lra. Qed.

Lemma l_positive M : contact_positive M -> 0 < l_of M.
Proof.
intros HM. rewrite l_value by exact HM. destruct HM as (H1 & H2 & _). apply Rdiv_lt_0_compat; [|lra].
apply pow_lt, H2.
Qed.

(** ** Derivatives in T *)

Lemma rate_same eps f f' f'' t : rate_in_T eps f t f' -> f' = f'' -> rate_in_T eps f t f''.
Proof. intros H <-; exact H. Qed.

Lemma rate_const eps (k : R) t : 0 < eps -> rate_in_T eps (fun _ => k) t 0.
Proof. intros He. unfold rate_in_T. eapply is_derive_val. apply is_derive_const. unfold zero; simpl. field. lra. Qed.

Lemma rate_scal eps f f' k t : 0 < eps -> rate_in_T eps f t f' -> rate_in_T eps (fun s => k * f s) t (k * f').
Proof. intros He Df. unfold rate_in_T. eapply is_derive_val. apply (is_derive_scal f t k), Df. field. lra. Qed.

Lemma rate_plus eps f f0 f' f0' t : 0 < eps -> rate_in_T eps f t f' -> rate_in_T eps f0 t f0' ->
  rate_in_T eps (fun s => f s + f0 s) t (f' + f0').
Proof.
intros He Df D0. unfold rate_in_T. eapply is_derive_val. apply (is_derive_plus f f0); eassumption.
unfold plus; simpl. field. lra.
Qed.

Lemma rate_minus eps f f0 f' f0' t : 0 < eps -> rate_in_T eps f t f' -> rate_in_T eps f0 t f0' ->
  rate_in_T eps (fun s => f s - f0 s) t (f' - f0').
Proof.
intros He Df D0. unfold rate_in_T. eapply is_derive_val. apply (is_derive_minus f f0); eassumption.
unfold minus, plus, opp; simpl. field. lra.
Qed.

Lemma rate_mult eps f f0 f' f0' t : 0 < eps -> rate_in_T eps f t f' -> rate_in_T eps f0 t f0' ->
  rate_in_T eps (fun s => f s * f0 s) t (f' * f0 t + f t * f0').
Proof.
intros He Df D0. unfold rate_in_T. eapply is_derive_val. apply (is_derive_mult_R f f0); eassumption. field. lra.
Qed.

(** What the equations say of lambda, with z' from eps c z'. *)
Lemma spring_rate M eps x t : contact_positive M -> 0 < eps -> moves_by M eps spring_force x t ->
  is_derive (spring_force M eps x) t
    (k2 M * ((- (k1 M * z x t) - eps ^ 2 * spring_force M eps x t) / (c M * eps) - v x t) / eps ^ 2).
Proof.
intros (H1 & H2 & H3) He (_ & _ & Dy & _ & Dz).
assert (Dz' : is_derive (z x) t ((- (k1 M * z x t) - eps ^ 2 * spring_force M eps x t) / (c M * eps))).
{ eapply derive_same. apply (is_derive_scal (fun s => c M * eps * z x s) t (/ (c M * eps))), Dz.
  intros s; cbv beta. field. lra. field. lra. }
eapply derive_same.
- apply (is_derive_scal (fun s => z x s - y x s) t (k2 M / eps ^ 2)).
  apply (is_derive_minus (z x) (y x)); eassumption.
- intros s. unfold spring_force. field. lra.
- unfold minus, plus, opp; simpl. field. lra.
Qed.

Theorem good_coordinates : StatementPassage.good_coordinates.
Proof.
intros M eps x t HM He H1 H13 Hp HX hr.
assert (DS := spring_rate M eps x t HM He HX). assert (Hk := kappa_positive M HM). assert (Hg := g_positive M HM).
destruct HM as (K1 & K2 & Kc). destruct HX as (Dp & Db & Dy & Dv & _).
assert (Hlg : l_of M / g_of M = c M * (k2 M / (k1 M + k2 M)) ^ 2).
{ unfold l_of, g_of, kappa_of. field. repeat split; lra. }
set (lambda := spring_force M eps x) in *.
assert (Hz : z x t = y x t + eps ^ 2 / k2 M * lambda t) by (unfold lambda, spring_force; field; lra).
rewrite Hz in DS.
refine (conj _ (conj _ (conj _ _))); unfold rate_in_T.
- unfold L_at. eapply is_derive_val.
  + apply (is_derive_minus (fun s => - b x s / p x s) (fun _ => mean_of M)).
    * apply (is_derive_div (fun s => - b x s) (p x)); [apply (is_derive_opp (b x)), Db|exact Dp|exact Hp].
    * apply is_derive_const.
  + unfold minus, plus, opp, zero, hr, W_at, mean_of, beta_of; simpl. fold lambda. field. repeat split; auto; lra.
- eapply derive_same. apply (is_derive_scal (v x) t (/ eps)), Dv.
  + intros s. unfold V_at, Rdiv. ring.
  + unfold W_at. fold lambda. field. lra.
- unfold W_at. fold lambda. eapply is_derive_val.
  + apply (is_derive_plus (b x) (fun s => p x s * lambda s)); [exact Db|].
    apply (is_derive_mult_R (p x) lambda); [exact Dp|exact DS].
  + unfold plus, hr, V_at, L_at, phi_at, mean_of, beta_of; simpl. rewrite Hlg. unfold V_at. fold lambda.
    unfold g_of, kappa_of.
    field. repeat split; auto; lra.
- eapply (derive_same (fun s => lambda s + kappa_of M / eps ^ 2 * y x s + l_of M / g_of M / eps * v x s)).
  + apply (is_derive_plus (fun s => lambda s + kappa_of M / eps ^ 2 * y x s)).
    apply (is_derive_plus lambda); [exact DS|]. apply (is_derive_scal (y x)), Dy. apply (is_derive_scal (v x)), Dv.
  + intros s. unfold phi_at, V_at. fold lambda. field. repeat split; lra.
  + unfold plus, phi_at, V_at, W_at, mean_of; simpl. fold lambda. rewrite Hlg. unfold g_of, kappa_of.
    field. repeat split; auto; lra.
Qed.

Theorem coordinates_determine : StatementPassage.coordinates_determine.
Proof.
intros M eps x x' t HM He Hp Ep EL EV EW Ephi.
assert (Hk := kappa_positive M HM). destruct HM as (K1 & K2 & Kc).
assert (Eb : b x t = b x' t).
{ unfold L_at in EL. rewrite <- Ep in EL.
  assert (Q : - b x t / p x t * p x t = - b x' t / p x t * p x t) by (f_equal; lra).
  unfold Rdiv in Q. rewrite !Rmult_assoc, Rinv_l, !Rmult_1_r in Q by auto. lra. }
assert (Ev : v x t = v x' t).
{ unfold V_at in EV. apply (Rmult_eq_compat_r eps) in EV. unfold Rdiv in EV.
  rewrite !Rmult_assoc, Rinv_l, !Rmult_1_r in EV by lra. exact EV. }
assert (Es : spring_force M eps x t = spring_force M eps x' t).
{ unfold W_at in EW. rewrite <- Ep, <- Eb in EW. apply Rmult_eq_reg_l with (p x t); auto. lra. }
assert (He2 : 0 < eps ^ 2) by (apply pow_lt, He).
assert (Ey : y x t = y x' t).
{ unfold phi_at in Ephi. rewrite EV, Es in Ephi.
  assert (Q : kappa_of M / eps ^ 2 * y x t = kappa_of M / eps ^ 2 * y x' t) by (unfold Rdiv in *; lra).
  apply Rmult_eq_reg_l in Q; auto. apply Rgt_not_eq, Rdiv_lt_0_compat; auto. }
refine (conj Eb (conj Ey (conj Ev _))).
unfold spring_force in Es. rewrite <- Ey in Es.
assert (Q : k2 M / eps ^ 2 * z x t = k2 M / eps ^ 2 * z x' t) by (unfold Rdiv in *; lra).
apply Rmult_eq_reg_l in Q; auto. apply Rgt_not_eq, Rdiv_lt_0_compat; auto.
Qed.

(** ** Polynomials in h and r along a motion *)

Lemma total_rate eps (F : monomials) (f f' : one_term -> R -> R) t : (forall a, rate_in_T eps (f a) t (f' a t)) ->
  rate_in_T eps (fun s => total F (fun a => f a s)) t (total F (fun a => f' a t)).
Proof.
intros H. unfold rate_in_T. replace (total F (fun a => f' a t) / eps) with (total F (fun a => f' a t / eps)).
- apply (total_derive F f (fun a t => f' a t / eps)), H.
- unfold Rdiv at 2. rewrite (Rmult_comm _ (/ eps)), <- total_scal. apply total_ext. intros a. unfold Rdiv. ring.
Qed.

Section Along.
Variables (M : model_system) (eps : R) (x : motion) (t : R).
Hypothesis Heps : 0 < eps.
Hypothesis Hp : 0 < p x t.
Hypothesis Dp : is_derive (p x) t (alpha1 M).
Let h := h_at M eps x.
Let r := r_at x.

Lemma r_positive : 0 < r t.
Proof. apply sqrt_lt_R0, Hp. Qed.

Lemma p_is_square : p x t = r t ^ 2.
Proof. unfold r, r_at. simpl. rewrite Rmult_1_r, sqrt_sqrt; lra. Qed.

Lemma h_value : h t = - alpha1 M * eps / r t ^ 3.
Proof.
unfold h, h_at. rewrite p_is_square. fold (r_at x t) r. rewrite sqrt_pow2 by apply Rlt_le, r_positive.
assert (R0 := r_positive). field. lra.
Qed.

Lemma hr_value : h t * r t = - alpha1 M * eps / p x t.
Proof. rewrite h_value, p_is_square. assert (R0 := r_positive). field. lra. Qed.

Lemma r_rate : rate_in_T eps r t (- (h t * r t ^ 2) / 2).
Proof.
unfold rate_in_T. assert (R0 := r_positive). eapply is_derive_val.
- apply (is_derive_sqrt (p x) t (alpha1 M)); assumption.
- fold (r_at x t). fold r. rewrite h_value. field. lra.
Qed.

Lemma h_rate : rate_in_T eps h t (3 / 2 * h t ^ 2 * r t).
Proof.
assert (R0 := r_positive). unfold rate_in_T. eapply is_derive_val.
- apply (is_derive_div (fun _ => - alpha1 M * eps) (fun s => p x s * r s)).
  + apply is_derive_const.
  + apply (is_derive_mult_R (p x) r); [exact Dp|apply r_rate].
  + rewrite p_is_square. apply Rgt_not_eq, Rmult_lt_0_compat; auto. apply pow_lt, R0.
- unfold zero; simpl. rewrite h_value, p_is_square. field. lra.
Qed.

Lemma monomial_rate a :
  rate_in_T eps (fun s => monomial a (h s) (r s)) t (h t * r t * (E_of a * monomial a (h t) (r t))).
Proof.
assert (R0 := r_positive). destruct a as [q i n]. unfold monomial, E_of; simpl by_h; simpl by_r.
assert (Q : forall f f' j, rate_in_T eps f t f' -> rate_in_T eps (fun s => f s ^ j) t (INR j * f' * f t ^ pred j)).
{ intros f f' j Df. unfold rate_in_T. eapply is_derive_val.
  apply (is_derive_pow f j t (f' / eps)), Df. field. lra. }
assert (P : forall u j, u * (INR j * u ^ pred j) = INR j * u ^ j).
{ intros u [|j]; simpl pred. simpl; ring. simpl pow. ring. }
unfold rate_in_T. eapply is_derive_val.
- apply (is_derive_mult_R (fun s => h s ^ i) (fun s => r s ^ n)); apply Q; [apply h_rate|apply r_rate].
- replace (INR i * (3 / 2 * h t ^ 2 * r t) * h t ^ pred i) with (3 / 2 * (h t * r t) * (h t * (INR i * h t ^ pred i)))
    by field.
  replace (INR n * (- (h t * r t ^ 2) / 2) * r t ^ pred n) with (- (h t * r t) / 2 * (r t * (INR n * r t ^ pred n)))
    by field.
  rewrite !P. field. lra.
Qed.

Lemma value_rate F : rate_in_T eps (fun s => value_of F (h s) (r s)) t (change F (h t) (r t)).
Proof.
unfold change. rewrite <- total_scal.
apply (total_rate eps F (fun a s => coefficient a * monomial a (h s) (r s))
  (fun a s => h s * r s * (coefficient a * E_of a * monomial a (h s) (r s)))).
intros a. unfold rate_in_T. eapply is_derive_val.
apply (is_derive_scal (fun s => monomial a (h s) (r s)) t (coefficient a)), monomial_rate. field. lra.
Qed.

End Along.

(** (4) is the Proposition, the product rule and (3). *)
Theorem deviation_moves : StatementPassage.deviation_moves.
Proof.
intros M P eps x t HM He H1 H13 Hp HX h r X.
destruct (good_coordinates M eps x t HM He H1 H13 ltac:(lra) HX) as (DL & DV & DW & Dphi).
assert (Dp := proj1 HX).
assert (Dr := r_rate M eps x t He Hp Dp). assert (DF := value_rate M eps x t He Hp Dp).
assert (R0 := r_positive x t Hp). assert (Ep := p_is_square x t Hp).
rewrite <- (hr_value M eps x t Hp) in DL, DW. assert (G0 := g_positive M HM).
fold r in Dr, R0, Ep, DL, DW. fold h in Dr, DL, DW. rewrite Ep in DL, DW.
assert (Dr2 : rate_in_T eps (fun s => r_at x s ^ 2) t (- (h * r ^ 3))).
{ eapply derive_same. apply (rate_mult eps (r_at x) (r_at x)); [exact He| |]; exact Dr. intros s; simpl; ring.
  fold r. field. lra. }
destruct P as [Pv Pw Pf].
assert (Dv := DF Pv). assert (Dw := DF Pw). assert (Df := DF Pf). clear DF.
unfold X, deviation_at; simpl.
refine (conj _ (conj _ _)).
- eapply rate_same. apply (rate_mult eps (r_at x)); [exact He|exact Dr|]. apply rate_minus; [exact He|exact DV|].
  apply (rate_mult eps (L_at M x)); [exact He|exact DL|exact Dv].
  unfold r_V, D_along; simpl slow_v; simpl slow_w; simpl slow_f. fold h r. field. lra.
- eapply rate_same. apply (rate_minus eps (W_at M eps x)); [exact He|exact DW|].
  apply (rate_mult eps (fun s => L_at M x s * r_at x s ^ 2)); [exact He| |exact Dw].
  apply (rate_mult eps (L_at M x)); [exact He|exact DL|exact Dr2].
  unfold r_W, D_along; simpl slow_v; simpl slow_w; simpl slow_f. fold h r. field. lra.
- eapply rate_same. apply (rate_mult eps (r_at x)); [exact He|exact Dr|].
  apply (rate_minus eps (phi_at M eps x)); [exact He|exact Dphi|].
  apply (rate_mult eps (fun s => L_at M x s * r_at x s ^ 2)); [exact He| |exact Df].
  apply (rate_mult eps (L_at M x)); [exact He|exact DL|exact Dr2].
  unfold r_phi, D_along; simpl slow_v; simpl slow_w; simpl slow_f. fold h r. field. lra.
Qed.
