(** * The arithmetic of the checker is right

    [holds m y]: the number y is the value of the model m up to its error. Each operation of [Checker.v] on models keeps
    this. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate Checker.
Import ListNotations.
Open Scope R_scope.

(** ** Polynomials *)
Section Models.
Variable eta : R.
Hypothesis Heta : Rabs eta <= 1.

Fixpoint value (p : poly) : R :=
  match p with
  | [] => 0
  | z :: p => IZR z + eta * value p
  end.

Fixpoint combined (rho : nat -> R) (p : list poly) : R :=
  match p with
  | [] => 0
  | a :: p => rho 0%nat * value a + combined (fun i => rho (S i)) p
  end.

Lemma value_plus p : forall q, value (poly_plus p q) = value p + value q.
Proof.
induction p as [|a p IH]; intros [|b q]; simpl; try ring. rewrite IH, plus_IZR. ring.
Qed.

Lemma value_times n p : value (poly_times n p) = IZR n * value p.
Proof. induction p as [|a p IH]; simpl. ring. fold (poly_times n p). rewrite IH, mult_IZR. ring. Qed.

Lemma value_linear n r p : value (poly_linear n r p) = (IZR n + IZR r * eta) * value p.
Proof. unfold poly_linear. rewrite value_plus. simpl. rewrite !value_times. ring. Qed.

Lemma poly_norm_pos p : (0 <= poly_norm p)%Z.
Proof. induction p; simpl; lia. Qed.

Lemma times_at_most_one x y B : Rabs x <= 1 -> Rabs y <= B -> Rabs (x * y) <= B.
Proof.
intros Hx Hy. rewrite Rabs_mult. replace B with (1 * B) by ring. apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma Rabs_plus_le x y a b : Rabs x <= a -> Rabs y <= b -> Rabs (x + y) <= a + b.
Proof. intros Hx Hy. assert (H := Rabs_triang x y). lra. Qed.

Lemma value_norm p : Rabs (value p) <= IZR (poly_norm p).
Proof.
induction p as [|a p IH]; simpl. rewrite Rabs_R0. lra.
rewrite plus_IZR, abs_IZR. apply Rabs_plus_le. lra. apply times_at_most_one; auto.
Qed.

Lemma value_split n p : Rabs (value p - value (firstn n p)) <= IZR (poly_norm (skipn n p)).
Proof.
revert p. induction n as [|n IH]; intros [|a p].
- simpl. rewrite Rminus_0_r, Rabs_R0. lra.
- cbn [firstn skipn]. change (value []) with 0. rewrite Rminus_0_r. apply value_norm.
- simpl. rewrite Rminus_0_r, Rabs_R0. lra.
- simpl. replace (IZR a + eta * value p - (IZR a + eta * value (firstn n p)))
    with (eta * (value p - value (firstn n p))) by ring.
  apply times_at_most_one; auto.
Qed.

(** Division of each coefficient, rounded down. *)
Lemma div_between z d : (0 < d)%Z -> Rabs (IZR z / IZR d - IZR (z / d)) <= 1.
Proof.
intros Hd. assert (D : 0 < IZR d) by (apply IZR_lt; auto).
assert (M := Z.mod_pos_bound z d Hd). assert (E := Z.div_mod z d ltac:(lia)).
assert (E' : IZR z = IZR d * IZR (z / d) + IZR (z mod d)) by (rewrite <- mult_IZR, <- plus_IZR, <- E; reflexivity).
rewrite E'. replace ((IZR d * IZR (z / d) + IZR (z mod d)) / IZR d - IZR (z / d)) with (IZR (z mod d) / IZR d)
  by (field; lra).
destruct M as [M1 M2]. apply IZR_le in M1. apply IZR_lt in M2.
rewrite Rabs_pos_eq.
- apply Rmult_le_reg_r with (IZR d); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
- apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, D.
Qed.

Lemma value_div d p : (0 < d)%Z ->
  Rabs (value p / IZR d - value (map (fun z => (z / d)%Z) p)) <= IZR (Z.of_nat (length p)).
Proof.
intros Hd. assert (D : 0 < IZR d) by (apply IZR_lt; auto). induction p as [|a p IH].
- simpl. unfold Rdiv. rewrite Rmult_0_l, Rminus_0_r, Rabs_R0. lra.
- cbn [value map length]. rewrite Nat2Z.inj_succ, succ_IZR.
  replace ((IZR a + eta * value p) / IZR d - (IZR (a / d) + eta * value (map (fun z => (z / d)%Z) p)))
    with (eta * (value p / IZR d - value (map (fun z => (z / d)%Z) p)) + (IZR a / IZR d - IZR (a / d))) by (field; lra).
  apply Rabs_plus_le. apply times_at_most_one; auto. apply div_between, Hd.
Qed.

(** ** Lists of polynomials *)
Definition weights (rho : nat -> R) : Prop := forall i, Rabs (rho i) <= 1.

Lemma weights_tail rho : weights rho -> weights (fun i => rho (S i)).
Proof. intros H i. apply H. Qed.

Lemma combined_plus p : forall rho q, combined rho (parts_plus p q) = combined rho p + combined rho q.
Proof.
induction p as [|a p IH]; intros rho [|b q]; simpl; try ring. rewrite IH, value_plus. ring.
Qed.

Lemma combined_times n p : forall rho, combined rho (map (poly_times n) p) = IZR n * combined rho p.
Proof. induction p as [|a p IH]; intros rho; simpl. ring. rewrite IH, value_times. ring. Qed.

Lemma combined_linear n r p : forall rho, combined rho (map (poly_linear n r) p) = (IZR n + IZR r * eta)
  * combined rho p.
Proof. induction p as [|a p IH]; intros rho; simpl. ring. rewrite IH, value_linear. ring. Qed.

Lemma parts_norm_pos p : (0 <= parts_norm p)%Z.
Proof. induction p as [|a p IH]. simpl; lia. assert (H := poly_norm_pos a). change (0 <= poly_norm a + parts_norm p)%Z.
lia. Qed.

Lemma combined_norm p : forall rho, weights rho -> Rabs (combined rho p) <= IZR (parts_norm p).
Proof.
induction p as [|a p IH]; intros rho Hr; simpl. rewrite Rabs_R0. lra.
rewrite plus_IZR. apply Rabs_plus_le. apply times_at_most_one. apply Hr. apply value_norm. apply IH, weights_tail, Hr.
Qed.

Lemma combined_kept d p : (0 < d)%Z -> forall rho degrees, weights rho ->
  Rabs (combined rho p / IZR d - combined rho (kept d degrees p))
    <= IZR (dropped degrees p) / IZR d + IZR (count_coefficients (kept d degrees p)).
Proof.
intros Hd. assert (D : 0 < IZR d) by (apply IZR_lt; auto).
assert (Z0 : 0 / IZR d = 0) by (unfold Rdiv; ring).
assert (None_kept : forall p rho, weights rho -> Rabs (combined rho p / IZR d - 0) <= IZR (parts_norm p) / IZR d + 0).
{ intros q rho Hr. rewrite Rminus_0_r, Rplus_0_r. unfold Rdiv.
  rewrite Rabs_mult, (Rabs_pos_eq (/ IZR d)) by (apply Rlt_le, Rinv_0_lt_compat, D).
  apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, D. apply combined_norm, Hr. }
induction p as [|a p IH]; intros rho degrees Hr.
- destruct degrees; unfold dropped, parts_norm, count_coefficients; simpl; rewrite ?Z0, Rminus_0_r, Rabs_R0; lra.
- destruct degrees as [|n degrees]; [exact (None_kept (a :: p) rho Hr)|].
  cbn [kept dropped combined count_coefficients fold_right]. rewrite !plus_IZR, map_length.
  assert (I := IH _ degrees (weights_tail _ Hr)). fold (count_coefficients (kept d degrees p)).
  set (C := combined (fun i => rho (S i)) p) in *. set (C' := combined (fun i => rho (S i)) (kept d degrees p)) in *.
  set (V := value a). set (V' := value (firstn n a)). set (V'' := value (map (fun z => (z / d)%Z) (firstn n a))).
  replace ((rho 0%nat * V + C) / IZR d - (rho 0%nat * V'' + C'))
    with (rho 0%nat * (/ IZR d * (V - V') + (V' / IZR d - V'')) + (C / IZR d - C')) by (field; lra).
  replace ((IZR (poly_norm (skipn n a)) + IZR (dropped degrees p)) / IZR d
     + (IZR (Z.of_nat (length (firstn n a))) + IZR (count_coefficients (kept d degrees p))))
    with ((IZR (poly_norm (skipn n a)) / IZR d + IZR (Z.of_nat (length (firstn n a))))
      + (IZR (dropped degrees p) / IZR d + IZR (count_coefficients (kept d degrees p)))) by (field; lra).
  apply Rabs_plus_le; auto. apply times_at_most_one. apply Hr. apply Rabs_plus_le.
  + rewrite Rabs_mult, (Rabs_pos_eq (/ IZR d)) by (apply Rlt_le, Rinv_0_lt_compat, D). unfold Rdiv. rewrite Rmult_comm.
    apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, D. apply value_split.
  + apply value_div, Hd.
Qed.

(** ** Models *)
Variable rho : nat -> R.
Hypothesis Hrho : weights rho.

Definition holds (m : model) (y : R) : Prop := Rabs (y - combined rho (parts m)) <= IZR (error m).

Lemma holds_error m y : holds m y -> 0 <= IZR (error m).
Proof. intros H. assert (P := Rabs_pos (y - combined rho (parts m))). unfold holds in H. lra. Qed.

Lemma holds_plus m m' y y' : holds m y -> holds m' y' -> holds (model_plus m m') (y + y').
Proof.
intros H H'. unfold holds, model_plus in *. simpl. rewrite combined_plus, plus_IZR.
replace (y + y' - (combined rho (parts m) + combined rho (parts m')))
  with ((y - combined rho (parts m)) + (y' - combined rho (parts m'))) by ring.
apply Rabs_plus_le; auto.
Qed.

Lemma holds_zero : holds zero_model 0.
Proof. unfold holds. simpl. rewrite Rminus_0_r, Rabs_R0. lra. Qed.

Lemma holds_times n m y : holds m y -> holds (model_times n m) (IZR n * y).
Proof.
intros H. unfold holds, model_times in *. simpl.
rewrite combined_times, mult_IZR, abs_IZR, <- Rmult_minus_distr_l, Rabs_mult.
apply Rmult_le_compat_l; auto using Rabs_pos.
Qed.

Lemma holds_linear n r m y : holds m y -> holds (model_linear n r m) ((IZR n + IZR r * eta) * y).
Proof.
intros H. unfold holds, model_linear in *. simpl.
rewrite combined_linear, mult_IZR, plus_IZR, !abs_IZR, <- Rmult_minus_distr_l, Rabs_mult.
apply Rmult_le_compat; auto using Rabs_pos. apply Rabs_plus_le. lra. rewrite Rmult_comm. apply times_at_most_one; auto.
lra.
Qed.

Lemma holds_shrink degrees d m y : (0 < d)%Z -> holds m y -> holds (shrink degrees d m) (y / IZR d).
Proof.
intros Hd H. assert (D : 0 < IZR d) by (apply IZR_lt; auto). unfold holds, shrink in *. simpl.
assert (K := combined_kept d (parts m) Hd rho degrees Hrho).
set (C := combined rho (parts m)) in *. set (C' := combined rho (kept d degrees (parts m))) in *.
rewrite !plus_IZR.
replace (y / IZR d - C') with (/ IZR d * (y - C) + (C / IZR d - C')) by (field; lra).
set (e := error m) in *. set (r := dropped degrees (parts m)) in *.
set (n := count_coefficients (kept d degrees (parts m))) in *.
assert (B : IZR (e + r) / IZR d <= IZR ((e + r) / d) + 1).
{ assert (Q := div_between (e + r) d Hd). apply Rabs_le_between in Q. lra. }
apply Rle_trans with (IZR e / IZR d + (IZR r / IZR d + IZR n)).
- apply Rabs_plus_le; auto. rewrite Rabs_mult, (Rabs_pos_eq (/ IZR d)) by (apply Rlt_le, Rinv_0_lt_compat, D).
  unfold Rdiv. rewrite Rmult_comm.
  apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, D.
- rewrite plus_IZR in B. replace ((IZR e + IZR r) / IZR d) with (IZR e / IZR d + IZR r / IZR d) in B by (field; lra).
  lra.
Qed.

Lemma holds_norm m y : holds m y -> Rabs y <= IZR (model_norm m).
Proof.
intros H. unfold holds, model_norm in *. rewrite plus_IZR. assert (C := combined_norm (parts m) rho Hrho).
replace y with (combined rho (parts m) + (y - combined rho (parts m))) by ring. apply Rabs_plus_le; auto.
Qed.

(** A change by at most e. *)
Lemma holds_wider m y y' e : holds m y -> Rabs (y' - y) <= IZR e -> holds (Model (parts m) (error m + e)) y'.
Proof.
intros H He. unfold holds in *. simpl. rewrite plus_IZR.
replace (y' - combined rho (parts m)) with ((y - combined rho (parts m)) + (y' - y)) by ring. apply Rabs_plus_le; auto.
Qed.

Lemma sign_of_right rest m y y' s : rho 0%nat = 1 -> holds m y -> Rabs (y' - y) <= IZR rest ->
  sign_of rest m = Some s -> 0 < signed s y'.
Proof.
intros Hr0 H He Hs. unfold sign_of in Hs. unfold holds in H. destruct (parts m) as [|[|z a] p] eqn:E; try discriminate.
cbn [combined value] in H. rewrite Hr0 in H.
assert (Va := times_at_most_one eta _ _ Heta (value_norm a)).
assert (Vp := combined_norm p _ (weights_tail _ Hrho)).
set (A := eta * value a) in *. set (P := combined (fun i => rho (S i)) p) in *.
apply Rabs_le_between in H. apply Rabs_le_between in He. apply Rabs_le_between in Va. apply Rabs_le_between in Vp.
destruct (Z.ltb_spec (poly_norm a + parts_norm p + error m + rest) z) as [L|L].
- injection Hs as <-. apply IZR_lt in L. rewrite !plus_IZR in L. simpl. lra.
- destruct (Z.ltb_spec (poly_norm a + parts_norm p + error m + rest) (- z)) as [L'|L']; [|discriminate].
  injection Hs as <-. apply IZR_lt in L'. rewrite !plus_IZR, opp_IZR in L'. simpl. lra.
Qed.

End Models.
