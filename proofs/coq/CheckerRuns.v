(** * The checker runs

    On two files, by Coq's own virtual machine ([vm_compute], part of its kernel); the theorems then say what follows.
    And on certificates that are wrong: it must not accept them. *)

From Coq Require Import String.
From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate CertificateText Checker CheckerCertificate CertificateIWC
  CertificateZeros StatementChecker
  CheckerEnclosure CheckerComparisons CheckerSound.
Import ListNotations.
Open Scope R_scope.

(** The kernel computes once, at the end of each proof. *)
Lemma iwc_0_1_accepted : accepts iwc_0_1_plans iwc_0_1 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma zeros_1_2_accepted : accepts zeros_1_2_plans zeros_1_2 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma open_interval p q b : Q2R p < b < Q2R q -> in_range (real_range (Interval (At p) (At q) false false)) b.
Proof. intros H. exact H. Qed.

Theorem iwc_0_1_checked : StatementChecker.iwc_0_1_checked.
Proof.
split; [|split; [exact iwc_0_1_accepted|split; [reflexivity|]]].
- exists "4e010080ce0749605ae9a0a8f9f0821463091a8e44c11d40d2263fd188686045"%string. vm_compute. reflexivity.
- intros F t b HF Hb. assert (H := accepted_is_true F _ _ HF iwc_0_1_accepted t b (conj I I)).
  enough (A : 0 < signed false (Derive (F b) t)) by (simpl in A; lra). apply H, open_interval.
  unfold Q2R. simpl. lra.
Qed.

Theorem zeros_1_2_checked : StatementChecker.zeros_1_2_checked.
Proof.
split; [|split; [exact zeros_1_2_accepted|split; [reflexivity|]]].
- exists "52d63bf5b21fb31fd2d0a1116b5517bfebb67cf404691f011f68d309ae8b0817"%string. vm_compute. reflexivity.
- intros F b HF Hb.
  assert (Nb : not_nat b).
  { intros [|[|n]] E; [simpl in E; lra|simpl in E; lra|]. rewrite !S_INR in E. assert (P := pos_INR n). lra. }
  destruct (accepted_is_true F _ _ HF zeros_1_2_accepted b) as (m & n & l & I & Hm & [Z0 Z] & L & S).
  + apply open_interval. unfold Q2R. simpl. lra.
  + exact Nb.
  + destruct I as [E|[]]. injection E as <- <-. destruct l as [|z [|]]; try discriminate. exists z.
    split; [|apply S; left; reflexivity].
    intros t. rewrite (Z t). simpl. split; [intros [E|[]]; auto|auto].
Qed.

(** ** What is not true is not accepted *)
Open Scope Q_scope.

Definition whole_line : interval := Interval MinusInfinity PlusInfinity false false.
Definition one_plan : list plan := firstn 1 iwc_0_1_plans.

(** One column of beta from 0 to 1/4. *)
Definition one_column (beta_end : Q) (s : bool) (pieces : list entry) : certificate :=
  Certificate (SignClaim whole_line (Interval (At 0) (At beta_end) false false) s) [Block (At 0) (1 # 4) pieces].

Example one_column_is_accepted :
  accepts one_plan (one_column (1 # 4) false [Left (-81 # 64); Sign (-81 # 64) (-1) true; Sign (-1) 0 true; Taylor])
    = true.
Proof. vm_compute. reflexivity. Qed.

Example a_wrong_sign : accepts one_plan (one_column (1 # 4) true [Left (-81 # 64); Sign (-81 # 64) (-1) false;
  Sign (-1) 0 false; Taylor]) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_wrong_sign_of_one_piece :
  accepts one_plan (one_column (1 # 4) false [Left (-81 # 64); Sign (-81 # 64) (-1) true; Sign (-1) 0 false; Taylor])
    = false.
Proof. vm_compute. reflexivity. Qed.

Example a_gap_between_pieces :
  accepts one_plan (one_column (1 # 4) false [Left (-81 # 64); Sign (-81 # 64) (-1) true; Sign (-1 # 2) 0 true; Taylor])
    = false.
Proof. vm_compute. reflexivity. Qed.

Example not_the_whole_line : accepts one_plan (one_column (1 # 4) false [Left (-81 # 64); Sign (-81 # 64) 0 true])
  = false.
Proof. vm_compute. reflexivity. Qed.

Example a_left_end_too_near : accepts one_plan (one_column (1 # 4) false [Left (-1 # 4); Sign (-1 # 4) 0 true; Taylor])
  = false.
Proof. vm_compute. reflexivity. Qed.

Example a_column_too_short :
  accepts one_plan (one_column (1 # 2) false [Left (-81 # 64); Sign (-81 # 64) (-1) true; Sign (-1) 0 true; Taylor])
    = false.
Proof. vm_compute. reflexivity. Qed.

(** One column of beta from 5/4 to 3/2, where F has one zero, between 1/2 and 3/2. *)
Definition one_zero (count : nat) (middle : list entry) (changes_at_end : nat) : certificate :=
  Certificate (ZerosClaim (Interval (At (5 # 4)) (At (3 # 2)) true true) [(1, count)%nat])
    [Block (At (5 # 4)) (3 # 2) (Left (-5 # 8) :: Sign (-5 # 8) (1 # 2) true :: middle ++ [Right (3 # 2)
      changes_at_end])].
Definition its_plan : list plan := firstn 1 (skipn 2 zeros_1_2_plans).

Example one_zero_is_accepted : accepts its_plan (one_zero 1 [Monotone (1 # 2) (3 # 2) false] 0) = true.
Proof. vm_compute. reflexivity. Qed.

Example a_wrong_count : accepts its_plan (one_zero 2 [Monotone (1 # 2) (3 # 2) false] 0) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_wrong_direction : accepts its_plan (one_zero 1 [Monotone (1 # 2) (3 # 2) true] 0) = false.
Proof. vm_compute. reflexivity. Qed.

Example no_sign_around_a_zero : accepts its_plan (one_zero 0 [Sign (1 # 2) (3 # 2) true] 1) = false.
Proof. vm_compute. reflexivity. Qed.

Example wrong_changes_at_the_end : accepts its_plan (one_zero 2 [Monotone (1 # 2) (3 # 2) false] 1) = false.
Proof. vm_compute. reflexivity. Qed.

Example an_empty_plan_shows_nothing :
  accepts [Plan 6 5 1 0 [1]%nat (Effort 10 1 1 0 5)] (one_zero 1 [Monotone (1 # 2) (3 # 2) false] 0) = false.
Proof. vm_compute. reflexivity. Qed.
