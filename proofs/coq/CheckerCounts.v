(** * A certificate of the number of zeros by the count law alone

    [counted] looks at the claim, not at the pieces: the count law gives the number for every beta that is not an
    integer ([counted_is_true]). *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qround Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate CertificatePieces CertificateText CheckerCertificate
  CheckerEnclosure StatementChecker
  CheckerComparisons EntireForm CountLaw.
Import ListNotations.
Open Scope R_scope.

Theorem counted_is_true F c : theta_family F -> counted c = true -> true_claim F c.
Proof.
intros HF H. destruct c as [|[[|low|] [|high|] from to] counts]; try discriminate.
apply andb_prop in H. destruct H as [H Listed]. apply andb_prop in H. destruct H as [H0 Right].
apply Qle_bool_R in H0. rewrite Q2R_0 in H0. rewrite forallb_forall in Listed, Right.
intros b Hb Nb. assert (B := in_range_closure _ _ Hb). cbn in B. destruct B as [B1 B2].
destruct (nfloor_ex b ltac:(lra)) as (m & [[Hm|E] Hm']); [|exfalso; apply (Nb m); auto].
assert (F1 := Qle_Rle _ _ (Qfloor_le low)). assert (F2 := Qle_Rle _ _ (Qle_ceiling high)). rewrite Q2R_whole in F1, F2.
assert (L1 : (Qfloor low < Z.of_nat m + 1)%Z) by (apply lt_IZR; rewrite plus_IZR, <- INR_IZR_INZ; lra).
assert (L2 : (Z.of_nat m < Qceiling high)%Z) by (apply lt_IZR; rewrite <- INR_IZR_INZ; lra).
destruct (proj1 (existsb_exists _ _) (Listed m ltac:(apply in_seq; lia))) as (m' & I & Em).
apply Nat.eqb_eq in Em. subst m'. apply in_map_iff in I. destruct I as ([m' n] & Em & I). cbn in Em. subst m'.
assert (En := Right _ I). apply Nat.eqb_eq in En. cbn in En.
assert (T := proj2 (proj1 (entire_initial_values b (F b)) Nb) (HF b)).
destruct (count_law m b (F b) (conj Hm Hm') T) as (l & Len & Sorted & Zeros & Simple).
exists m, n, l. rewrite En in I |- *. exact (conj I (conj (conj Hm Hm') (conj (conj Sorted Zeros) (conj Len Simple)))).
Qed.

(** The claim of proofs/zeros_1_13.cert, and claims that are not accepted. *)
Open Scope Q_scope.

Definition open_range (low high : Q) : interval := Interval (At low) (At high) false false.

Example zeros_1_13_counted : counted (ZerosClaim (open_range 1 13)
  [(1, 1); (2, 2); (3, 1); (4, 2); (5, 3); (6, 2); (7, 3); (8, 4); (9, 3); (10, 4); (11, 5); (12, 4)]%nat) = true.
Proof. reflexivity. Qed.

Example a_cell_of_which_a_part_is_asked : counted (ZerosClaim (open_range (1 # 2) (3 # 2)) [(0, 0); (1, 1)]%nat) = true.
Proof. reflexivity. Qed.

Example a_count_that_is_not_the_law : counted (ZerosClaim (open_range 1 3) [(1, 1); (2, 1)]%nat) = false.
Proof. reflexivity. Qed.

Example a_cell_without_a_count : counted (ZerosClaim (open_range 1 (5 # 2)) [(1, 1)]%nat) = false.
Proof. reflexivity. Qed.

Example a_cell_with_two_counts : counted (ZerosClaim (open_range 1 2) [(1, 1); (1, 5)]%nat) = false.
Proof. reflexivity. Qed.

Example a_negative_beta : counted (ZerosClaim (open_range (-1 # 2) 1) [(0, 0)]%nat) = false.
Proof. reflexivity. Qed.

Example a_sign_is_no_count : counted (SignClaim (open_range 1 2) (open_range 1 2) true) = false.
Proof. reflexivity. Qed.
