(** * An example that satisfies all hypotheses of Theorem B

    So that no hypothesis is empty: beta = 5/4, alpha1 = alpha2 = -1, the paper's contact, the slow part V = L h r/2,
    on h <= 1/1000, r <= 1/100; e <= 10^-9/64. Lemma 1 there: x^T N x is (h r/4 + 7 r^2/64) x1^2 + (h r/2 + 7 r^2/32)
    x2^2 + 31 x3^2 or more, up to mixed terms that these squares pay for. *)

From Coq Require Import Reals Psatz Lra List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus StatementStep StatementPassage.
Import ListNotations.
Open Scope R_scope.

Definition example_model : model_system := Model (-1) (-1) (- (5 / 4)) 1 1 1.
Definition example_part : slow_part := SlowPart [Term (1 / 2) 1 1] [] [].
Definition example_weights : weights := Weights (1 / 2) 1.
Definition example_numbers : numbers :=
  Numbers (1 / 10000) 1 (1 / 20000) (1 / 1000 * (1 / 400) ^ 3) (1 / 1000) (1 / 100) (1 / 8) (1 / 64) (7 / 5) (1 / 100)
    0 0.
Definition example_source : monomials := [Term (3 / 8) 1 0].
Definition example_barrier : monomials := [Term (15 / 4) 1 0].

Lemma example_constants : beta_of example_model = 5 / 4 /\ kappa_of example_model = 1 / 2 /\ g_of example_model = 2 /\
  l_of example_model = 1 / 2 /\ mean_of example_model = 4.
Proof. unfold beta_of, g_of, l_of, kappa_of, mean_of; simpl. repeat split; field. Qed.

(** The mixed terms. *)
Lemma squares_pay (A B C n12 n13 n23 x1 x2 x3 u v0 : R) : 0 <= u -> 0 <= v0 ->
  u / 8 + v0 / 16 <= A -> u / 8 + 7 * v0 / 40 <= B -> 31 <= C -> Rabs n12 <= (u + v0) / 100 ->
    n13 ^ 2 <= (u + v0) / 100 ->
  n23 ^ 2 <= 9 * v0 / 2 + u / 10 ->
  0 <= A * x1 ^ 2 + B * x2 ^ 2 + C * x3 ^ 2 + 2 * n12 * (x1 * x2) + 2 * n13 * (x1 * x3) + 2 * n23 * (x2 * x3).
Proof.
intros Hu Hv HA HB HC H12 H13 H23. apply Rabs_le_between in H12.
assert (X1 := pow2_ge_0 x1). assert (X2 := pow2_ge_0 x2). assert (X3 := pow2_ge_0 x3).
assert (S1 := pow2_ge_0 (x1 - x2)). assert (S2 := pow2_ge_0 (x1 + x2)).
assert (M12 : - ((u + v0) / 100) * (x1 ^ 2 + x2 ^ 2) <= 2 * n12 * (x1 * x2)).
{ assert (0 <= ((u + v0) / 100 + n12) * (x1 + x2) ^ 2) by (apply Rmult_le_pos; lra).
  assert (0 <= ((u + v0) / 100 - n12) * (x1 - x2) ^ 2) by (apply Rmult_le_pos; lra). lra. }
assert (M13 : - ((u + v0) / 100) * x1 ^ 2 - x3 ^ 2 <= 2 * n13 * (x1 * x3)).
{ assert (0 <= (n13 * x1 + x3) ^ 2) by apply pow2_ge_0.
  assert (n13 ^ 2 * x1 ^ 2 <= (u + v0) / 100 * x1 ^ 2) by (apply Rmult_le_compat_r; auto). lra. }
assert (M23 : - ((9 * v0 / 2 + u / 10) / 30) * x2 ^ 2 - 30 * x3 ^ 2 <= 2 * n23 * (x2 * x3)).
{ assert (0 <= (n23 * x2 + 30 * x3) ^ 2) by apply pow2_ge_0.
  assert (n23 ^ 2 * x2 ^ 2 <= (9 * v0 / 2 + u / 10) * x2 ^ 2) by (apply Rmult_le_compat_r; auto). lra. }
assert (D1 : (u / 8 + v0 / 16) * x1 ^ 2 <= A * x1 ^ 2) by (apply Rmult_le_compat_r; auto).
assert (D2 : (u / 8 + 7 * v0 / 40) * x2 ^ 2 <= B * x2 ^ 2) by (apply Rmult_le_compat_r; auto).
assert (D3 : 31 * x3 ^ 2 <= C * x3 ^ 2) by (apply Rmult_le_compat_r; auto).
assert (P1 : 0 <= u * x1 ^ 2) by (apply Rmult_le_pos; auto).
assert (P2 : 0 <= u * x2 ^ 2) by (apply Rmult_le_pos; auto).
assert (P3 : 0 <= v0 * x1 ^ 2) by (apply Rmult_le_pos; auto).
assert (P4 : 0 <= v0 * x2 ^ 2) by (apply Rmult_le_pos; auto).
lra.
Qed.

Lemma example_growth : growth_checked example_model example_part example_weights (1 / 8) (1 / 64) (1 / 1000) (1 / 100).
Proof.
intros h r [x1 x2 x3] Hh Hr. unfold growth_form, product_M, B_times, m_entry, n_entry.
destruct example_constants as (-> & -> & -> & -> & _). unfold value_of, monomial; simpl.
assert (U0 : 0 < h * r) by (apply Rmult_lt_0_compat; lra). assert (V0 : 0 < r ^ 2) by (apply pow_lt; lra).
assert (U1 : h * r <= 1 / 100000) by (replace (1 / 100000) with (1 / 1000 * (1 / 100)) by field;
  apply Rmult_le_compat; lra).
assert (V1 : r ^ 2 <= 1 / 10000) by (replace (1 / 10000) with ((1 / 100) ^ 2) by field; apply pow_incr; lra).
assert (H2 : 0 <= h ^ 2 <= 1 / 1000000) by (replace (1 / 1000000) with ((1 / 1000) ^ 2) by field; split;
  [apply pow2_ge_0|apply pow_incr; lra]).
assert (T : forall q c0 d, 0 <= q -> 0 <= c0 <= d -> 0 <= c0 * q <= d * q) by (intros; split;
  [apply Rmult_le_pos|apply Rmult_le_compat_r]; lra).
assert (A1 := T (h * r) h (1 / 1000) ltac:(lra) ltac:(lra)). assert (A2 := T (h * r) r (1 / 100) ltac:(lra) ltac:(lra)).
assert (A3 := T (r ^ 2) r (1 / 100) ltac:(lra) ltac:(lra)). assert (A4 := T (h * r) (h ^ 2) _ ltac:(lra) H2).
assert (A5 := T (r ^ 2) (h ^ 2) _ ltac:(lra) H2).
assert (A6 := T (h * r) (h * r) _ ltac:(lra) (conj (Rlt_le _ _ U0) U1)).
assert (A7 := T (r ^ 2) (h * r) _ ltac:(lra) (conj (Rlt_le _ _ U0) U1)).
assert (A8 := T (r ^ 2) (r ^ 2) _ ltac:(lra) (conj (Rlt_le _ _ V0) V1)).
assert (Q := squares_pay (h * r / 4 + 7 * r ^ 2 / 64)
  (15 / 32 * (h ^ 2 * (h * r)) - 5 / 32 * (h ^ 2 * r ^ 2) + h * r / 2 + 7 * r ^ 2 / 32)
  (10 * (h * r) - 17 / 4 * r ^ 2 + 32)
  (h * (h * r) / 16 + 35 / 256 * (r * (h * r)) - r * r ^ 2 / 256) (- (3 / 4 * (h * r)) - r ^ 2 / 4)
  (r * (r ^ 2 / 32 - h * r - 2)) x1 x2 x3 (h * r) (r ^ 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (Q12 : Rabs (h * (h * r) / 16 + 35 / 256 * (r * (h * r)) - r * r ^ 2 / 256) <= (h * r + r ^ 2) / 100)
  by (apply Rabs_le; lra).
assert (Q13 : (- (3 / 4 * (h * r)) - r ^ 2 / 4) ^ 2 <= (h * r + r ^ 2) / 100) by lra.
assert (Q23 : (r * (r ^ 2 / 32 - h * r - 2)) ^ 2 <= 9 * r ^ 2 / 2 + h * r / 10).
{ rewrite Rpow_mult_distr. assert (W : 0 <= (r ^ 2 / 32 - h * r - 2) ^ 2 <= 9 / 2).
  { replace (r ^ 2 / 32 - h * r - 2) with (- (2 + h * r - r ^ 2 / 32)) by ring.
    rewrite <- Rsqr_pow2, <- Rsqr_neg, Rsqr_pow2.
    split. apply pow2_ge_0. apply Rle_trans with ((21 / 10) ^ 2); [apply pow_incr|]; lra. }
  assert (X := T (r ^ 2) _ _ ltac:(lra) W). lra. }
specialize (Q Q12 Q13 Q23). simpl in Q. lra.
Qed.

Lemma example_source_bounds : source_of example_model example_part example_source (1 / 1000) (1 / 100).
Proof.
intros h r Hh Hr. destruct example_constants as (Eb & Ek & Eg & El & _).
assert (Sk : sqrt (kappa_of example_model) <= 1) by (rewrite Ek; apply Rle_trans with (sqrt 1);
  [apply sqrt_le_1_alt|rewrite sqrt_1]; lra).
assert (EV : r_V example_model example_part h r = - (3 / 8 * (h ^ 2 * r ^ 2))).
{ unfold r_V, D_along, change, value_of, E_of, monomial; rewrite Eb; simpl. field. }
assert (EW : r_W example_model example_part h r = 0).
{ unfold r_W, D_along, change, value_of, E_of, monomial; rewrite Eb, Ek; simpl. field. }
assert (Ephi : r_phi example_model example_part h r = 0).
{ unfold r_phi, D_along, change, value_of, E_of, monomial; simpl. ring. }
rewrite EV, EW, Ephi, Rabs_R0, Rabs_Ropp, Rabs_pos_eq.
- unfold value_of, monomial; simpl. unfold Rdiv. rewrite Rmult_0_r, !Rmult_0_l, !Rplus_0_r.
  replace (sqrt (kappa_of example_model) * (3 * / 8 * (h * (h * 1) * (r * (r * 1)))) * / (h * (r * (r * 1))))
    with (sqrt (kappa_of example_model) * (3 / 8 * h)) by (field; lra).
  apply Rle_trans with (1 * (3 / 8 * h)); [apply Rmult_le_compat_r|]; lra.
- apply Rmult_le_pos; [lra|apply Rmult_le_pos; apply pow2_ge_0].
Qed.

Lemma example_d : 99 / 100 <= d_of example_model example_weights (1 / 1000) (1 / 100).
Proof.
unfold d_of. destruct example_constants as (-> & -> & -> & -> & _). simpl.
rewrite Rmax_left by lra. lra.
Qed.

Lemma example_p_at_h : p_at_h (1 / 1000 * (1 / 400) ^ 3) (1 / 1000) = (1 / 400) ^ 2.
Proof.
unfold p_at_h. replace (1 / 1000 * (1 / 400) ^ 3 / (1 / 1000)) with ((1 / 400) ^ 3) by field.
rewrite <- !Rpower_pow, Rpower_mult by lra. f_equal. simpl. field.
Qed.

Example passage_is_possible :
  passage_checked example_model example_part example_weights example_numbers example_source example_barrier.
Proof.
destruct example_constants as (Eb & _ & _ & _ & Em). assert (Hd := example_d).
assert (Hc : c_W example_model example_weights (1 / 1000) (1 / 100) <= 2).
{ unfold c_W. replace 2 with (/ / 2) by field. apply Rinv_le_contravar. lra.
  apply Rle_trans with (sqrt (/ 2 * / 2)). rewrite sqrt_square; lra. apply sqrt_le_1_alt. lra. }
constructor; unfold example_numbers; cbn [p1 L1 z0 e0 h1 r1 Gamma_E theta Gamma z_max w_plus w_minus];
  rewrite ?example_p_at_h, ?Eb; try lra.
- unfold contact_positive; simpl. lra.
- repeat split; try lra. replace (1 / 10000) with (1 / 100 * (1 / 100)) by field. rewrite sqrt_square; lra.
- exact example_growth.
- exact example_source_bounds.
- intros h r _ _. unfold value_of; simpl. lra.
- apply (one_more _ _ (Term (3 / 8) 1 0) [] [Term (15 / 4) 1 0] []); [simpl; lra| |constructor].
  apply at_once; unfold E_of; simpl; lra.
- unfold value_of, monomial; simpl total. unfold layer. replace (1 / 10000 / (1 / 400) ^ 2) with 16 by field.
  assert (R1 : Rpower 16 (7 / 5) <= 64).
  { apply Rle_trans with (Rpower 16 (3 / 2)). apply Rle_Rpower; lra.
    replace 16 with (4 ^ 2) by ring. rewrite <- Rpower_pow, Rpower_mult by lra.
    replace (INR 2 * (3 / 2)) with (INR 3) by (simpl; field). rewrite Rpower_pow by lra. lra. }
  match goal with |- context [exp ?u] => assert (E1 : exp u <= 1) by (apply Rle_trans with (exp 0);
    [apply exp_le|rewrite exp_0]; lra);
    assert (E0 := exp_pos u); set (X := exp u) in * end.
  assert (R0 : 0 < Rpower 16 (7 / 5)) by apply exp_pos.
  assert (Y : Rpower 16 (7 / 5) * X <= 64 * 1) by (apply Rmult_le_compat; lra).
  unfold Rmax. destruct Rle_dec; lra.
Qed.
