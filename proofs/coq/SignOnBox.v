(** * The value on a box

    Section 4 of proofs/check.md: for |u| <= 1 and |eta| <= 1/2 the d-th derivative is the first coefficient of its
    first model, up to the other coefficients, the other terms and the errors. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementModels RecurrenceTail DerivativeTail BoxModel CarriedModel.
Open Scope R_scope.

Lemma half_size_bound m eta : Rabs eta <= 1 / 2 -> Rabs (polynomial m eta) <= half_size m.
Proof.
intros He. induction m as [|a m IH]; simpl. rewrite Rabs_R0. lra.
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l. rewrite Rabs_mult.
unfold Rdiv. rewrite Rmult_comm. apply Rmult_le_compat; try apply Rabs_pos; auto. lra.
Qed.

Lemma half_size_tail m eta : Rabs eta <= 1 / 2 -> Rabs (polynomial m eta - hd 0 m) <= half_size (tl m) / 2.
Proof.
intros He. destruct m as [|a m]; simpl. rewrite Rminus_0_r, Rabs_R0. lra.
replace (a + eta * polynomial m eta - a) with (eta * polynomial m eta) by ring. rewrite Rabs_mult.
unfold Rdiv. rewrite Rmult_comm. apply Rmult_le_compat; try apply Rabs_pos; [apply half_size_bound, He|lra].
Qed.

Theorem box_value b t0 s B f (n d : nat) (m : nat -> list R) (e : nat -> R) u eta : solution b f -> 0 < s -> 1 <= B ->
  Rabs b + 2 <= B ->
  (d <= 2)%nat -> (5 <= n)%nat -> ratio t0 s B (n - 5) <= 1 / 2 -> Rabs u <= 1 -> Rabs eta <= 1 / 2 ->
  let a k := Derive_n f k t0 / INR (fact k) * s ^ k in
  let rest := 3 * Rmax (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat))) in
  (forall k, (k < n - 1)%nat -> Rabs (a k - polynomial (m k) eta) <= e k) ->
  Rabs (a (n - 1)%nat - polynomial (m (n - 1)%nat) eta) + rest <= e (n - 1)%nat ->
  Rabs (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d) - hd 0 (m d)) <=
    half_size (tl (m d)) / 2 + sum_first (fun j => Binomial.C (d + 1 + j) d * half_size (m (d + 1 + j)%nat)) (n - d - 1)
    + sum_first (fun j => Binomial.C (d + j) d * e (d + j)%nat) (n - d).
Proof.
intros H Hs HB Hb Hd Hn Hq Hu He a rest Hp Hlast.
assert (M := moved_series b t0 s B f n d (fun k => polynomial (m k) eta) e (fun k => Rabs (polynomial (m k) eta) + e k)
  (fun j => u ^ j) u 0
  H Hs HB Hb Hd Hn Hq Hu Hp Hlast (fun k _ => Rle_refl _) (Rle_refl 0)
  (fun j _ => ltac:(rewrite Rminus_diag_eq, Rabs_R0, Rmult_0_r by reflexivity; apply Rle_refl))).
assert (U : forall j, Rabs (u ^ j) <= 1).
{ intros j. rewrite <- RPow_abs, <- (pow1 j). apply pow_incr. split; [apply Rabs_pos|exact Hu]. }
assert (E0 : forall k, (k < n)%nat -> 0 <= e k).
{ intros k Hk. destruct (Nat.eq_dec k (n - 1)) as [->|Nk].
  - assert (A := Rabs_pos (a (n - 1)%nat - polynomial (m (n - 1)%nat) eta)).
    assert (R0 : 0 <= rest). { unfold rest. assert (R1 := Rabs_pos (a (n - 3)%nat)).
    assert (R2 := Rmax_l (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat)))). lra. }
    lra.
  - assert (A := Hp k ltac:(lia)). assert (A' := Rabs_pos (a k - polynomial (m k) eta)). lra. }
assert (ER : sum_first (fun j =>
  Binomial.C (d + j) d * (Rabs (u ^ j) * e (d + j)%nat + INR (d + j) * 0 * (Rabs (polynomial (m (d + j)%nat) eta)
    + e (d + j)%nat))) (n - d)
  <= sum_first (fun j => Binomial.C (d + j) d * e (d + j)%nat) (n - d)).
{ assert (Le : forall v w N, (forall j, (j < N)%nat -> v j <= w j) -> sum_first v N <= sum_first w N).
  { intros v w N L. induction N as [|N IH]; simpl; [lra|].
    apply Rplus_le_compat; [apply IH; intros; apply L; lia|apply L; lia]. }
  apply Le. intros j Hj. apply Rmult_le_compat_l; [apply Rlt_le, binomial_pos|].
  rewrite Rmult_0_r, Rmult_0_l, Rplus_0_r, <- (Rmult_1_l (e (d + j)%nat)) at 1. rewrite Rmult_1_l.
  rewrite <- (Rmult_1_l (e (d + j)%nat)) at 2. apply Rmult_le_compat_r; [apply E0; lia|apply U]. }
cbv beta in M. set (P := fun j => Binomial.C (d + j) d * polynomial (m (d + j)%nat) eta * u ^ j) in M.
assert (Split : sum_first P (n - d) = polynomial (m d) eta + sum_first (fun j => P (1 + j)%nat) (n - d - 1)).
{ replace (n - d)%nat with (1 + (n - d - 1))%nat at 1 by lia. rewrite sum_split. f_equal. simpl. unfold P.
  rewrite Nat.add_0_r. unfold Binomial.C. rewrite Nat.sub_diag. simpl. field. apply INR_fact_neq_0. }
assert (Tau : Rabs (sum_first (fun j => P (1 + j)%nat) (n - d - 1)) <=
  sum_first (fun j => Binomial.C (d + 1 + j) d * half_size (m (d + 1 + j)%nat)) (n - d - 1)).
{ apply sum_bound. intros j _. unfold P. replace (d + (1 + j))%nat with (d + 1 + j)%nat by lia.
  rewrite !Rabs_mult, (Rabs_pos_eq (Binomial.C _ _)) by (apply Rlt_le, binomial_pos).
  rewrite <- (Rmult_1_r (Binomial.C (d + 1 + j) d * half_size _)).
  apply Rmult_le_compat; [|apply Rabs_pos| |apply U].
  - apply Rmult_le_pos; [apply Rlt_le, binomial_pos|apply Rabs_pos].
  - apply Rmult_le_compat_l; [apply Rlt_le, binomial_pos|apply half_size_bound, He]. }
assert (Beta := half_size_tail (m d) eta He). rewrite Split in M.
set (y := s ^ d * Derive_n f d (t0 + s * u) / INR (fact d)) in *.
set (Q := sum_first (fun j => P (1 + j)%nat) (n - d - 1)) in *. set (p0 := polynomial (m d) eta) in *.
replace (y - hd 0 (m d)) with ((y - (p0 + Q)) + (Q + (p0 - hd 0 (m d)))) by ring.
eapply Rle_trans; [apply Rabs_triang|]. assert (T := Rabs_triang Q (p0 - hd 0 (m d))). lra.
Qed.
