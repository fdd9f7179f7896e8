(** * A step of the recurrence with rounded coefficients

    Models and section 2 of proofs/check.md: alpha f_1 + (g - r eta) f from models of f and f_1 with D coefficients
    each. The coefficient of eta^D is left out, the others are rounded by at most one unit. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementModels DerivativeTail BoxModel.
Open Scope R_scope.

Lemma polynomial_sum m x : polynomial m x = sum_first (fun j => nth j m 0 * x ^ j) (length m).
Proof.
induction m as [|a m IH]; auto.
change (polynomial (a :: m) x) with (a + x * polynomial m x). change (length (a :: m)) with (1 + length m)%nat.
rewrite sum_split, IH.
rewrite <- sum_first_factor. simpl. f_equal; [ring|]. apply sum_ext. intros k _. ring.
Qed.

(** x_(-1) = 0 *)
Definition before (m : list R) (j : nat) : R := match j with O => 0 | S i => nth i m 0 end.

Lemma shifted_sum m x : (0 < length m)%nat ->
  sum_first (fun j => before m j * x ^ j) (length m) = x * polynomial m x - last m 0 * x ^ length m.
Proof.
intros Hm. rewrite polynomial_sum. destruct (length m) as [|D] eqn:E; [lia|]. clear Hm.
assert (L : last m 0 = nth D m 0).
{ revert D E. induction m as [|a m IH]; intros D E; [discriminate|]. destruct m as [|a' m].
  - injection E as <-. reflexivity.
  - destruct D as [|D]; [discriminate|]. injection E as E. change (last (a' :: m) 0 = nth D (a' :: m) 0). apply IH.
    simpl. rewrite E. reflexivity. }
rewrite L. change (S D) with (1 + D)%nat at 1. rewrite sum_split. cbn [sum_first before].
rewrite Rmult_plus_distr_l, <- sum_first_factor.
replace (sum_first (fun k => before m (1 + k) * x ^ (1 + k)) D) with (sum_first (fun k => x * (nth k m 0 * x ^ k)) D).
2: { apply sum_ext. intros k _. simpl. ring. }
simpl. ring.
Qed.

Theorem rounded_step unit alpha g r (x y m : list R) ex ey (f f1 : R -> R) : 0 <= r -> (0 < length x)%nat ->
  length y = length x -> length m = length x ->
  is_model (x, ex) f -> is_model (y, ey) f1 ->
  (forall j, (j < length x)%nat -> Rabs (nth j m 0 - (alpha * nth j y 0 + g * nth j x 0 - r * match j with O => 0 |
    S i => nth i x 0 end)) <= unit) ->
  is_model (m, Rabs alpha * ey + (Rabs g + r) * ex + r * Rabs (last x 0) + INR (length x) * unit) (fun eta =>
    alpha * f1 eta + (g - r * eta) * f eta).
Proof.
intros Hr HD Hy Hm Mx My Hround eta He. specialize (Mx eta He). specialize (My eta He). cbn [fst snd] in *.
set (D := length x) in *.
assert (Pow : forall j, Rabs (eta ^ j) <= 1).
{ intros j. rewrite <- RPow_abs, <- (pow1 j). apply pow_incr. split; [apply Rabs_pos|exact He]. }
set (exact_coefficient := fun j => alpha * nth j y 0 + g * nth j x 0 - r * before x j).
assert (Ex : sum_first (fun j => exact_coefficient j * eta ^ j) D
  = alpha * polynomial y eta + (g - r * eta) * polynomial x eta + r * (last x 0 * eta ^ D)).
{ assert (Sh := shifted_sum x eta HD). fold D in Sh. rewrite !polynomial_sum in *. rewrite Hy. fold D. fold D in Sh.
  rewrite (sum_ext _ (fun j => alpha * (nth j y 0 * eta ^ j)
    + (g * (nth j x 0 * eta ^ j) + - r * (before x j * eta ^ j)))).
  2: { intros k _. unfold exact_coefficient. ring. }
  rewrite !sum_plus, !sum_first_factor, Sh. ring. }
assert (Rnd : Rabs (polynomial m eta - sum_first (fun j => exact_coefficient j * eta ^ j) D) <= INR D * unit).
{ rewrite polynomial_sum, Hm. fold D.
  replace (sum_first (fun j => nth j m 0 * eta ^ j) D - sum_first (fun j => exact_coefficient j * eta ^ j) D)
    with (sum_first (fun j => (nth j m 0 - exact_coefficient j) * eta ^ j) D).
  - replace (INR D * unit) with (sum_first (fun _ => unit) D).
    + apply sum_bound. intros j Hj. assert (A := Hround j Hj). fold (before x j) in A. fold (exact_coefficient j) in A.
      rewrite Rabs_mult, <- (Rmult_1_r unit). apply Rmult_le_compat; auto; apply Rabs_pos.
    + clear. induction D as [|n IH]; [simpl; ring|]. rewrite S_INR. cbn [sum_first]. rewrite IH. ring.
  - rewrite (sum_ext (fun j => nth j m 0 * eta ^ j) (fun j => (nth j m 0 - exact_coefficient j) * eta ^ j
      + exact_coefficient j * eta ^ j)).
    2: { intros k _. ring. }
    rewrite sum_plus. ring. }
replace (alpha * f1 eta + (g - r * eta) * f eta - polynomial m eta)
  with (alpha * (f1 eta - polynomial y eta) + ((g - r * eta) * (f eta - polynomial x eta)
    + (- (r * (last x 0 * eta ^ D)) + - (polynomial m eta - sum_first (fun j => exact_coefficient j * eta ^ j) D))))
        by (rewrite Ex; ring).
assert (G : Rabs (g - r * eta) <= Rabs g + r).
{ unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l.
  rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq r) by exact Hr.
  rewrite <- (Rmult_1_r r) at 2. apply Rmult_le_compat_l; auto. }
assert (T1 : Rabs (alpha * (f1 eta - polynomial y eta)) <= Rabs alpha * ey)
  by (rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|exact My]).
assert (T2 : Rabs ((g - r * eta) * (f eta - polynomial x eta)) <= (Rabs g + r) * ex)
  by (rewrite Rabs_mult; apply Rmult_le_compat; auto; apply Rabs_pos).
assert (T3 : Rabs (- (r * (last x 0 * eta ^ D))) <= r * Rabs (last x 0)).
{ rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq r) by exact Hr. apply Rmult_le_compat_l; auto.
  rewrite <- (Rmult_1_r (Rabs (last x 0))) at 2.
  apply Rmult_le_compat_l; [apply Rabs_pos|apply Pow]. }
eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rplus_assoc. apply Rplus_le_compat; [exact T1|].
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [exact T2|].
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [exact T3|]. rewrite Rabs_Ropp. exact Rnd.
Qed.
