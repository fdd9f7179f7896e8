(** * The tail of the series of a derivative

    The rest of the lemma in section 4 of proofs/box.md. v_k = k!/(k-d)! |c_k| X^(k-d) are the terms of the d-th
    derivative of sum c_k t^k at |t| = X. The recurrence gives v_(k+3) <= (k + B) X^3/((k-d+1)(k-d+2)(k-d+3)) v_k, and
    this factor decreases in k; so each triple of terms is at most q times the one before, and the geometric series
    bounds the sum. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Open Scope R_scope.

Lemma sum_first_le (a a' : nat -> R) n : (forall k, a k <= a' k) -> sum_first a n <= sum_first a' n.
Proof. intros H. induction n as [|n IH]; simpl. lra. assert (A := H n). lra. Qed.

Lemma sum_first_shift3 (v : nat -> R) n : sum_first v (n + 3) = v 0%nat + v 1%nat + v 2%nat + sum_first (fun i =>
  v (i + 3)%nat) n.
Proof.
induction n as [|n IH].
- simpl. ring.
- change (sum_first v (S (n + 3)) = v 0%nat + v 1%nat + v 2%nat + (sum_first (fun i => v (i + 3)%nat) n
    + v (n + 3)%nat)).
  simpl (sum_first v (S (n + 3))). rewrite IH. ring.
Qed.

Lemma sum_first_factor q (v : nat -> R) n : sum_first (fun k => q * v k) n = q * sum_first v n.
Proof. induction n as [|n IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma sum_first_grows (v : nat -> R) n : (forall k, 0 <= v k) -> sum_first v n <= sum_first v (n + 3).
Proof.
intros H. replace (n + 3)%nat with (S (S (S n))) by lia. simpl.
assert (A := H n). assert (B := H (S n)). assert (C := H (S (S n))). lra.
Qed.

Lemma geometric_by_three q (v : nat -> R) n : 0 <= q < 1 -> (forall k, 0 <= v k) ->
  (forall k, v (k + 3)%nat <= q * v k) ->
  sum_first v n <= (v 0%nat + v 1%nat + v 2%nat) / (1 - q).
Proof.
intros Hq Hv H. set (T := v 0%nat + v 1%nat + v 2%nat).
assert (G := sum_first_grows v n Hv). assert (E := sum_first_shift3 v n).
assert (L : sum_first (fun i => v (i + 3)%nat) n <= q * sum_first v n).
{ rewrite <- sum_first_factor. apply sum_first_le, H. }
assert (M : q * sum_first v n <= q * sum_first v (n + 3)) by (apply Rmult_le_compat_l; lra).
apply Rle_trans with (sum_first v (n + 3)); auto.
apply Rmult_le_reg_r with (1 - q). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. fold T in E. lra.
Qed.

Section Tail.
Variables (b X B : R) (c : nat -> R) (d : nat).
Hypothesis HX : 0 <= X.
Hypothesis HB : 1 <= B.
Hypothesis Hb : Rabs b <= B.
Hypothesis Hc : forall k, (INR k + 1) * (INR k + 2) * (INR k + 3) * c (k + 3)%nat = (INR k - b) * c k.

Definition derivative_term (k : nat) : R := INR (fact k) / INR (fact (k - d)) * Rabs (c k) * X ^ (k - d).

Lemma derivative_term_pos k : 0 <= derivative_term k.
Proof.
unfold derivative_term. apply Rmult_le_pos; [apply Rmult_le_pos|apply pow_le, HX].
- apply Rlt_le, Rdiv_lt_0_compat; apply INR_fact_lt_0.
- apply Rabs_pos.
Qed.

Definition tail_factor (y : R) : R := (y + INR d + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)).

Lemma tail_factor_decreases x y : 0 <= x -> x <= y -> tail_factor y <= tail_factor x.
Proof.
intros Hx Hxy. unfold tail_factor. assert (HXp : 0 <= X ^ 3) by (apply pow_le, HX). assert (Hd := pos_INR d).
assert (E : forall u, 0 <= u -> (u + INR d + B) * X ^ 3 / ((u + 1) * (u + 2) * (u + 3))
  = X ^ 3 * ((1 + (INR d + B - 1) * / (u + 1)) * (/ (u + 2) * / (u + 3)))).
{ intros u Hu. field. repeat split; lra. }
rewrite !E by lra. apply Rmult_le_compat_l; auto.
assert (I : forall a, 0 < a -> 0 <= / (y + a) <= / (x + a)).
{ intros a Ha. split. apply Rlt_le, Rinv_0_lt_compat; lra. apply Rinv_le_contravar; lra. }
assert (I1 := I 1 ltac:(lra)). assert (I2 := I 2 ltac:(lra)). assert (I3 := I 3 ltac:(lra)).
assert (P : (INR d + B - 1) * / (y + 1) <= (INR d + B - 1) * / (x + 1)) by (apply Rmult_le_compat_l; lra).
assert (P0 : 0 <= (INR d + B - 1) * / (y + 1)) by (apply Rmult_le_pos; lra).
apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. apply Rmult_le_compat; lra.
Qed.

Lemma derivative_term_step k : (d <= k)%nat -> derivative_term (k + 3) <= tail_factor (INR (k - d)) * derivative_term k.
Proof.
intros Hk. unfold derivative_term, tail_factor.
replace (k + 3 - d)%nat with (S (S (S (k - d)))) by lia. replace (k + 3)%nat with (S (S (S k))) by lia.
rewrite !fact_simpl, !mult_INR, !S_INR.
set (y := INR (k - d)). assert (Hy : 0 <= y) by apply pos_INR.
assert (Ek : INR k = y + INR d) by (unfold y; rewrite minus_INR by auto; ring).
assert (Hk0 := pos_INR k).
assert (R : Rabs (c (S (S (S k)))) = Rabs (INR k - b) * Rabs (c k) / ((INR k + 1) * (INR k + 2) * (INR k + 3))).
{ assert (D : 0 < (INR k + 1) * (INR k + 2) * (INR k + 3)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (H := Hc k). replace (k + 3)%nat with (S (S (S k))) in H by lia.
  apply Rmult_eq_reg_l with ((INR k + 1) * (INR k + 2) * (INR k + 3)); [|lra].
  rewrite <- (Rabs_pos_eq ((INR k + 1) * (INR k + 2) * (INR k + 3))) at 1 by lra. rewrite <- Rabs_mult, H, Rabs_mult.
  field. lra. }
rewrite R.
assert (F1 := INR_fact_lt_0 k). assert (F2 := INR_fact_lt_0 (k - d)).
set (f := INR (fact k)) in *. set (g := INR (fact (k - d))) in *. set (a := Rabs (c k)).
assert (Ha : 0 <= a) by apply Rabs_pos.
set (Y := X ^ (k - d)). assert (HY : 0 <= Y) by (apply pow_le, HX).
assert (HXp : 0 <= X ^ 3) by (apply pow_le, HX).
assert (Hn : Rabs (INR k - b) <= y + INR d + B).
{ eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, (Rabs_pos_eq (INR k)) by lra. lra. }
assert (Z : 0 <= f / g * a * Y * X ^ 3 / ((y + 1) * (y + 2) * (y + 3))).
{ apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; lra].
  apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. apply Rlt_le, Rdiv_lt_0_compat; auto. }
replace (X ^ S (S (S (k - d)))) with (X ^ 3 * Y) by (unfold Y; simpl; ring).
replace ((INR k + 1 + 1 + 1) * ((INR k + 1 + 1) * ((INR k + 1) * f)) / ((y + 1 + 1 + 1) * ((y + 1 + 1) * ((y + 1) * g)))
  * (Rabs (INR k - b) * a / ((INR k + 1) * (INR k + 2) * (INR k + 3))) * (X ^ 3 * Y))
  with (Rabs (INR k - b) * (f / g * a * Y * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)))) by (field; repeat split; lra).
replace ((y + INR d + B) * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)) * (f / g * a * Y))
  with ((y + INR d + B) * (f / g * a * Y * X ^ 3 / ((y + 1) * (y + 2) * (y + 3)))) by (field; repeat split; lra).
apply Rmult_le_compat_r; auto.
Qed.

Theorem derivative_tail K N : (d <= K)%nat -> tail_factor (INR (K - d)) < 1 ->
  sum_first (fun i => derivative_term (K + i)) N
    <= (derivative_term K + derivative_term (K + 1) + derivative_term (K + 2)) / (1 - tail_factor (INR (K - d))).
Proof.
intros HK Hq. set (q := tail_factor (INR (K - d))) in *.
assert (Hq0 : 0 <= q).
{ unfold q, tail_factor. assert (P := pos_INR (K - d)). assert (Hd := pos_INR d).
  apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply pow_le, HX]|].
  apply Rlt_le, Rinv_0_lt_compat. repeat apply Rmult_lt_0_compat; lra. }
assert (G := geometric_by_three q (fun i => derivative_term (K + i)) N (conj Hq0 Hq) (fun k =>
  derivative_term_pos (K + k))).
cbv beta in G. replace (K + 0)%nat with K in G by lia. apply G.
intros k. replace (K + (k + 3))%nat with (K + k + 3)%nat by lia.
eapply Rle_trans; [apply derivative_term_step; lia|].
apply Rmult_le_compat_r. apply derivative_term_pos. apply tail_factor_decreases. apply pos_INR. apply le_INR. lia.
Qed.
End Tail.
