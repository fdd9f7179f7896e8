(** * The entire form of the initial values

    1/Gamma without poles; Gauss's multiplication formula for it at every x; so t01-t03 are 2 pi 3^(2b/3 - 1/2 + j/3)
    times a product of two values of 1/Gamma: E_j(b). E_0 solves the recurrence E_0(b) = (b - 1)(b - 2) E_0(b - 3), and
    E_1(b) = - b E_0(b - 1), E_2(b) = b (b - 1) E_0(b - 2): those of the values at 0. At integers this gives the
    polynomials P_n, from E_0(0) = 1 (Gamma(1/3) Gamma(2/3)), E_0(1) = E_0(2) = 0. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral WellPosed Gronwall Family SignsAtZero
  IntegerPolynomials
  PolynomialSum GammaMultiplication.
Open Scope R_scope.

Lemma recip_pos x : 0 < x -> recip_Gamma x = / Gamma x.
Proof. intros Hx. rewrite Gamma_GammaInt by auto. unfold recip_Gamma. rewrite steps_up_zero by auto. reflexivity. Qed.

Lemma recip_rec x : recip_Gamma x = x * recip_Gamma (x + 1).
Proof.
destruct (Rle_lt_dec x 0) as [H|H].
- unfold recip_Gamma. rewrite (steps_up_next x H). reflexivity.
- rewrite !recip_pos, Gamma_rec by lra. assert (G := Gamma_pos x H). field. lra.
Qed.

(** Down from x + n > 0. *)
Lemma down_from (step : R) (P : R -> Prop) : 0 < step -> (forall x, 0 < x -> P x) -> (forall x, P (x + step) -> P x) ->
  forall x, P x.
Proof.
intros Hs H0 H x.
assert (D : forall n x, 0 < x + INR n * step -> P x).
{ induction n as [|n IH]; intros y Hy.
  - apply H0. simpl in Hy. lra.
  - apply H, IH. rewrite S_INR in Hy. lra. }
destruct (nfloor_ex (Rabs x / step)) as [n [_ Hn]].
{ apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hs. }
apply (D (S n)). rewrite S_INR.
assert (A := Rle_abs (- x)). rewrite Rabs_Ropp in A.
assert (B : Rabs x < (INR n + 1) * step).
{ replace (Rabs x) with (Rabs x / step * step) by (field; lra). apply Rmult_lt_compat_r; auto. }
lra.
Qed.

Lemma recip_off_poles x : (forall n : nat, x <> - INR n) -> recip_Gamma x = / Gamma x.
Proof.
revert x. apply (down_from 1 (fun x => (forall n : nat, x <> - INR n) -> recip_Gamma x = / Gamma x)); [lra| |].
- intros x Hx _. apply recip_pos, Hx.
- intros x IH Hx. assert (H0 := Hx 0%nat). simpl in H0.
  rewrite recip_rec, IH, Gamma_rec.
  + field. split; [|lra]. apply Gamma_neq0, Hx.
  + lra.
  + intros n Hn. apply (Hx (S n)). rewrite S_INR. lra.
Qed.

Lemma recip_at_pole n : recip_Gamma (- INR n) = 0.
Proof.
induction n as [|n IH].
- simpl. rewrite recip_rec. ring.
- rewrite recip_rec. replace (- INR (S n) + 1) with (- INR n) by (rewrite S_INR; ring). rewrite IH. ring.
Qed.

Theorem reciprocal_gamma x : ((forall n : nat, x <> - INR n) -> recip_Gamma x = / Gamma x) /\
  ((exists n : nat, x = - INR n) -> recip_Gamma x = 0).
Proof. split; [apply recip_off_poles|]. intros [n ->]. apply recip_at_pole. Qed.

(** Gauss's formula for 1/Gamma, every x. *)
Lemma Gauss_recip x : recip_Gamma (3 * x) = 2 * PI * Rpower 3 (1 / 2 - 3 * x) * (recip_Gamma x * recip_Gamma
  (x + 1 / 3) * recip_Gamma (x + 2 / 3)).
Proof.
revert x. apply (down_from (1 / 3) (fun x => recip_Gamma (3 * x)
  = 2 * PI * Rpower 3 (1 / 2 - 3 * x) * (recip_Gamma x * recip_Gamma (x + 1 / 3) * recip_Gamma (x + 2 / 3)))); [lra| |].
- intros x Hx. rewrite !recip_pos by lra. assert (G := Gauss3 x Hx).
  assert (P1 := Gamma_pos x Hx). assert (P2 := Gamma_pos (x + 1 / 3) ltac:(lra)).
  assert (P3 := Gamma_pos (x + 2 / 3) ltac:(lra)).
  assert (P4 := Gamma_pos (3 * x) ltac:(lra)).
  set (c := 2 * PI * Rpower 3 (1 / 2 - 3 * x)) in *.
  apply (Rmult_eq_reg_l (Gamma (3 * x) * (Gamma x * Gamma (x + 1 / 3) * Gamma (x + 2 / 3)))).
  2: { apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; auto. }
  rewrite G at 1. field. repeat split; lra.
- intros x IH. rewrite recip_rec. replace (3 * x + 1) with (3 * (x + 1 / 3)) by field. rewrite IH.
  replace (x + 1 / 3 + 1 / 3) with (x + 2 / 3) by field. replace (x + 1 / 3 + 2 / 3) with (x + 1) by field.
  rewrite (recip_rec x). replace (1 / 2 - 3 * x) with (1 / 2 - 3 * (x + 1 / 3) + 1) by field.
  rewrite Rpower_plus, Rpower_1 by lra. ring.
Qed.

Theorem gauss_multiplication x : (forall n : nat, 3 * x <> - INR n) ->
  Gamma x * Gamma (x + 1 / 3) * Gamma (x + 2 / 3) = 2 * PI * Rpower 3 (1 / 2 - 3 * x) * Gamma (3 * x).
Proof.
intros Hx. assert (G := Gauss_recip x).
assert (N1 : forall n : nat, x <> - INR n).
{ intros n Hn. apply (Hx (3 * n)%nat). rewrite mult_INR, Hn. simpl. ring. }
assert (N2 : forall n : nat, x + 1 / 3 <> - INR n).
{ intros n Hn. apply (Hx (3 * n + 1)%nat). rewrite plus_INR, mult_INR. simpl. lra. }
assert (N3 : forall n : nat, x + 2 / 3 <> - INR n).
{ intros n Hn. apply (Hx (3 * n + 2)%nat). rewrite plus_INR, mult_INR. simpl. lra. }
rewrite !recip_off_poles in G by auto.
assert (Z1 := Gamma_neq0 _ N1). assert (Z2 := Gamma_neq0 _ N2). assert (Z3 := Gamma_neq0 _ N3).
assert (Z4 := Gamma_neq0 _ Hx).
set (c := 2 * PI * Rpower 3 (1 / 2 - 3 * x)) in *.
replace (c * Gamma (3 * x)) with (/ (/ Gamma (3 * x)) * c) by (field; auto).
assert (Hc : c <> 0).
{ unfold c. apply Rgt_not_eq. apply Rmult_lt_0_compat; [assert (P := PI_RGT_0); lra|apply exp_pos]. }
rewrite G. field. repeat split; auto.
Qed.

(** ** The initial values *)

Definition E0 (b : R) : R := 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2) * recip_Gamma ((1 - b) / 3) * recip_Gamma
  ((2 - b) / 3).
Definition E1 (b : R) : R := 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 1 / 3) * recip_Gamma (- b / 3) * recip_Gamma
  ((2 - b) / 3).
Definition E2 (b : R) : R := 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3) * recip_Gamma (- b / 3) * recip_Gamma
  ((1 - b) / 3).

Lemma power_shift x y (n : nat) : x = y + INR n -> Rpower 3 x = 3 ^ n * Rpower 3 y.
Proof. intros ->. rewrite Rpower_plus, (Rpower_pow n) by lra. ring. Qed.

Lemma E1_E0 b : E1 b = - b * E0 (b - 1).
Proof.
unfold E1, E0. rewrite (recip_rec (- b / 3)).
replace (- b / 3 + 1) with ((2 - (b - 1)) / 3) by field. replace ((1 - (b - 1)) / 3) with ((2 - b) / 3) by field.
rewrite (power_shift (2 * b / 3 - 1 / 2 + 1 / 3) (2 * (b - 1) / 3 - 1 / 2) 1) by (simpl; field). field.
Qed.

Lemma E2_E0 b : E2 b = b * (b - 1) * E0 (b - 2).
Proof.
unfold E2, E0. rewrite (recip_rec (- b / 3)), (recip_rec ((1 - b) / 3)).
replace (- b / 3 + 1) with ((1 - (b - 2)) / 3) by field. replace ((1 - b) / 3 + 1) with ((2 - (b - 2)) / 3) by field.
rewrite (power_shift (2 * b / 3 - 1 / 2 + 2 / 3) (2 * (b - 2) / 3 - 1 / 2) 2) by (simpl; field). field.
Qed.

Lemma E0_rec b : E0 b = (b - 1) * (b - 2) * E0 (b - 3).
Proof.
unfold E0. rewrite (recip_rec ((1 - b) / 3)), (recip_rec ((2 - b) / 3)).
replace ((1 - b) / 3 + 1) with ((1 - (b - 3)) / 3) by field.
replace ((2 - b) / 3 + 1) with ((2 - (b - 3)) / 3) by field.
rewrite (power_shift (2 * b / 3 - 1 / 2) (2 * (b - 3) / 3 - 1 / 2) 2) by (simpl; field). field.
Qed.

Lemma recip_0 : recip_Gamma 0 = 0.
Proof. rewrite recip_rec. ring. Qed.

Lemma E0_nat n : E0 (INR n) = Pn n 0.
Proof.
induction n as [| | |n IH] using nat_ind3.
- unfold E0. simpl INR. replace ((1 - 0) / 3) with (1 / 3) by field. replace ((2 - 0) / 3) with (2 / 3) by field.
  rewrite !recip_pos by lra.
  assert (S3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). assert (P := PI_RGT_0).
  replace (2 * 0 / 3 - 1 / 2) with (- / 2) by field. rewrite Rpower_Ropp, Rpower_sqrt by lra.
  assert (G1 := Gamma_pos (1 / 3) ltac:(lra)). assert (G2 := Gamma_pos (2 / 3) ltac:(lra)).
  replace (2 * PI * / sqrt 3 * / Gamma (1 / 3) * / Gamma (2 / 3))
    with (2 * PI * / sqrt 3 * / (Gamma (1 / 3) * Gamma (2 / 3))) by (field; repeat split; lra).
  rewrite Gamma_thirds. simpl Pn. field. split; lra.
- unfold E0. simpl INR. replace ((1 - 1) / 3) with 0 by field. rewrite recip_0. simpl. ring.
- unfold E0. replace ((2 - INR 2) / 3) with 0 by (simpl; field). rewrite recip_0. simpl. ring.
- rewrite E0_rec, Pn_rec. replace (INR (S (S (S n))) - 3) with (INR n) by (rewrite !S_INR; ring). rewrite IH, !S_INR.
  ring.
Qed.

Lemma E1_nat n : E1 (INR n) = Pn1 n 0.
Proof.
rewrite E1_E0. unfold Pn1. destruct n as [|n]. simpl. ring.
replace (INR (S n) - 1) with (INR n) by (rewrite S_INR; ring). rewrite E0_nat. replace (S n - 1)%nat with n by lia.
reflexivity.
Qed.

Lemma E2_nat n : E2 (INR n) = Pn2 n 0.
Proof.
rewrite E2_E0. unfold Pn2. destruct n as [|[|n]]. simpl; ring. simpl; ring.
replace (INR (S (S n)) - 2) with (INR n) by (rewrite !S_INR; ring). rewrite E0_nat.
replace (S (S n) - 2)%nat with n by lia. reflexivity.
Qed.

(** t01-t03 off the integers. *)
Lemma E_not_nat b : not_nat b ->
  E0 b = Gamma (- b / 3) / (Rpower 3 ((3 + b) / 3) * Gamma (- b)) /\
  E1 b = Gamma ((1 - b) / 3) / (Rpower 3 ((2 + b) / 3) * Gamma (- b)) /\
  E2 b = Gamma ((2 - b) / 3) / (Rpower 3 ((1 + b) / 3) * Gamma (- b)).
Proof.
intros Hb.
assert (G := Gauss_recip (- b / 3)).
replace (3 * (- b / 3)) with (- b) in G by field. replace (- b / 3 + 1 / 3) with ((1 - b) / 3) in G by field.
replace (- b / 3 + 2 / 3) with ((2 - b) / 3) in G by field.
assert (N0 : forall n : nat, - b <> - INR n) by (intros n Hn; apply (Hb n); lra).
assert (N1 : forall n : nat, - b / 3 <> - INR n).
{ intros n Hn. apply (Hb (3 * n)%nat). rewrite mult_INR. simpl. lra. }
assert (N2 : forall n : nat, (1 - b) / 3 <> - INR n).
{ intros n Hn. apply (Hb (3 * n + 1)%nat). rewrite plus_INR, mult_INR. simpl. lra. }
assert (N3 : forall n : nat, (2 - b) / 3 <> - INR n).
{ intros n Hn. apply (Hb (3 * n + 2)%nat). rewrite plus_INR, mult_INR. simpl. lra. }
rewrite !recip_off_poles in G by auto.
unfold E0, E1, E2. rewrite !recip_off_poles by auto.
assert (Z0 := Gamma_neq0 _ N0). assert (Z1 := Gamma_neq0 _ N1). assert (Z2 := Gamma_neq0 _ N2).
assert (Z3 := Gamma_neq0 _ N3).
assert (P := PI_RGT_0).
replace (1 / 2 - - b) with (1 / 2 + b) in G by ring.
set (T := Rpower 3 (2 * b / 3 - 1 / 2)). assert (HT : 0 < T) by apply exp_pos.
set (U := Rpower 3 (1 / 3)). assert (HU : 0 < U) by apply exp_pos.
set (V := Rpower 3 ((1 + b) / 3)). assert (HV : 0 < V) by apply exp_pos.
assert (U3 : U * U * U = 3). { unfold U. rewrite <- !Rpower_plus. replace (1 / 3 + 1 / 3 + 1 / 3) with 1 by field.
apply Rpower_1; lra. }
assert (EG : Rpower 3 (1 / 2 + b) = T * U * U * V).
{ unfold T, U, V. rewrite <- !Rpower_plus. f_equal. field. }
replace (Rpower 3 (2 * b / 3 - 1 / 2 + 1 / 3)) with (T * U) by (symmetry; apply Rpower_plus).
replace (Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3)) with (T * U * U).
2: { unfold T, U. rewrite <- !Rpower_plus. f_equal. field. }
replace (Rpower 3 ((2 + b) / 3)) with (U * V).
2: { unfold U, V. rewrite <- !Rpower_plus. f_equal. field. }
replace (Rpower 3 ((3 + b) / 3)) with (U * U * V).
2: { unfold U, V. rewrite <- !Rpower_plus. f_equal. field. }
rewrite EG in G.
set (g0 := Gamma (- b)) in *. set (g1 := Gamma (- b / 3)) in *. set (g2 := Gamma ((1 - b) / 3)) in *.
set (g3 := Gamma ((2 - b) / 3)) in *.
unfold Rdiv. rewrite !Rinv_mult, G.
repeat split; field; repeat split; auto; lra.
Qed.

Lemma entire_chain b theta : is_Theta_entire b theta ->
  (forall t, is_derive theta t (Derive theta t)) /\
  (forall t, is_derive (Derive theta) t (Derive_n theta 2 t)) /\
  (forall t, is_derive (Derive_n theta 2) t (t * Derive theta t - b * theta t)) /\
  theta 0 = E0 b /\ Derive theta 0 = E1 b /\ Derive_n theta 2 0 = E2 b.
Proof.
intros (Hex & Hode & I0 & I1 & I2).
assert (D : forall n t, (n < 3)%nat -> is_derive (Derive_n theta n) t (Derive_n theta (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n theta n)). exact (Hex (S n) t Hn). }
refine (conj (fun t => D 0%nat t ltac:(lia)) (conj (fun t => D 1%nat t ltac:(lia)) (conj _ (conj I0 (conj I1 I2))))).
intros t. replace (t * Derive theta t - b * theta t) with (Derive_n theta 3 t) by (generalize (Hode t); lra).
apply D; lia.
Qed.

Theorem entire_initial_values b theta :
  (not_nat b -> (is_Theta b theta <-> is_Theta_entire b theta)) /\
  (forall n : nat, b = INR n -> ((forall t, theta t = Poly n t) <-> is_Theta_entire b theta)).
Proof.
split.
- intros Hb. destruct (E_not_nat b Hb) as (H0 & H1 & H2). unfold E0 in H0. unfold E1 in H1. unfold E2 in H2.
  unfold is_Theta, is_Theta_entire. rewrite H0, H1, H2. reflexivity.
- intros n ->. split.
  + intros E.
    assert (EP : forall t, theta t = Pn n t) by (intros t; rewrite E; apply Poly_Pn).
    assert (D1 : forall t, Derive theta t = Pn1 n t).
    { intros t. rewrite (Derive_ext theta (Pn n)) by auto. apply Pn_Derive. }
    assert (D2 : forall t, Derive_n theta 2 t = Pn2 n t).
    { intros t. rewrite (Derive_n_ext theta (Pn n)) by auto. apply Pn_Derive2. }
    assert (D3 : forall t, Derive_n theta 3 t = t * Pn1 n t - INR n * Pn n t).
    { intros t. change (Derive (Derive_n theta 2) t = t * Pn1 n t - INR n * Pn n t).
      rewrite (Derive_ext _ (Pn2 n)) by auto. apply is_derive_unique, Pn_chain2. }
    refine (conj _ (conj _ (conj _ (conj _ _)))).
    * intros [|[|[|[|k]]]] t Hk; [exact I| | | |lia]; unfold ex_derive_n.
      -- eexists. apply (is_derive_ext (Pn n)); [intros; symmetry; apply EP|apply Pn_derive'].
      -- eexists. apply (is_derive_ext (Pn1 n)); [intros; symmetry; apply D1|apply Pn_chain1].
      -- eexists. apply (is_derive_ext (Pn2 n)); [intros; symmetry; apply D2|apply Pn_chain2].
    * intros t. rewrite D3, D1, EP. ring.
    * rewrite EP, <- E0_nat. reflexivity.
    * rewrite D1, <- E1_nat. reflexivity.
    * rewrite D2, <- E2_nat. reflexivity.
  + intros HE t. rewrite Poly_Pn.
    destruct (entire_chain _ _ HE) as (D0 & D1 & D2 & I0 & I1 & I2).
    rewrite E0_nat in I0. rewrite E1_nat in I1. rewrite E2_nat in I2.
    assert (H := gronwall_u0 (fun t => theta t - Pn n t) (fun t => Derive theta t - Pn1 n t)
      (fun t => Derive_n theta 2 t - Pn2 n t) (fun _ => 0) (- INR n) (Rabs t) 0 (Rabs_pos t)).
    assert (H' : (theta t - Pn n t) ^ 2 <= 0).
    { eapply Rle_trans. apply H.
      - intros s. apply (is_derive_minus theta (Pn n)); auto. apply Pn_derive'.
      - intros s. apply (is_derive_minus (Derive theta) (Pn1 n)); auto. apply Pn_chain1.
      - intros s.
        replace (s * (Derive theta s - Pn1 n s) + - INR n * (theta s - Pn n s) + 0) with
          ((s * Derive theta s - INR n * theta s) - (s * Pn1 n s - INR n * Pn n s)) by ring.
        apply (is_derive_minus (Derive_n theta 2) (Pn2 n)); auto. apply Pn_chain2.
      - intros; rewrite Rabs_R0; apply Rle_refl.
      - apply Rle_refl.
      - rewrite I0, I1, I2. right. unfold Rminus. rewrite !Rplus_opp_r. ring. }
    assert (A := pow2_ge_0 (theta t - Pn n t)). nra.
Qed.
