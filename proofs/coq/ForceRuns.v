(** * The checker of certificates about the contact force runs

    On three files, by Coq's own virtual machine ([vm_compute], part of its kernel); the theorems then say what follows.
    And on certificates that are wrong: it must not accept them. *)

From Coq Require Import String.
From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate CertificateText StatementChecker ForceText
  Checker CheckerCertificate ForceChecker DataForce DataLiftOff DataSlowZeros StatementForce CheckerComparisons
  ForceSound DipSound.
Import ListNotations.
Open Scope R_scope.

(** The kernel computes once, at the end of each proof. *)
Lemma force_5_2_accepted : force_accepts force_5_2_plans force_5_2 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma lift_off_5_2_accepted : force_accepts lift_off_5_2_plans lift_off_5_2 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma zeros_4_5_accepted : force_accepts zeros_4_5_plans zeros_4_5 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma Q2R_parts z d : Q2R (z # d) = IZR z / IZR (Zpos d).
Proof. reflexivity. Qed.

Theorem force_5_2_checked : StatementForce.force_5_2_checked.
Proof.
split; [|split; [exact force_5_2_accepted|split; [reflexivity|]]].
- exists "a14b2ee31e8df8c99f1c47c4510400d52bb9a2985afacdf72460fcb13b546886"%string. vm_compute. reflexivity.
- intros eps p b y v z He HS t. assert (H := force_accepted_is_true _ _ force_5_2_accepted).
  change (force_claimed force_5_2) with (ForceClaim (-1) (-1) (-5 # 2) (-1) (4 # 5) (5892556509887 # 10000000000000)
    (Interval MinusInfinity PlusInfinity false false)) in H.
  cbn [true_force_claim] in H. cbv zeta in H. rewrite !(Q2R_small (-1)), !Q2R_parts in H.
  apply (H eps p b y v z t).
  + exact He.
  + replace (-1 * Rpower eps (-5 / 2 / -1)) with (- Rpower eps (5 / 2)); [exact HS|].
    replace (-5 / 2 / -1) with (5 / 2) by field. ring.
  + exact (conj I I).
Qed.

Theorem lift_off_5_2_checked : StatementForce.lift_off_5_2_checked.
Proof.
split; [|split; [exact lift_off_5_2_accepted|split; [reflexivity|]]].
- exists "82c0e9f716332b7adfac9412b11cdbd590b91f9f581741aa3bc2dbe1724d45bf"%string. vm_compute. reflexivity.
- intros eps p b y v z t He HS Ht. assert (H := force_accepted_is_true _ _ lift_off_5_2_accepted).
  change (force_claimed lift_off_5_2) with (LiftOffClaim (-1) (-1) (-5 # 2) 1 (1 # 1000) (4714045207911 # 10000000000)
    (5537 # 1000)) in H.
  cbn [true_force_claim] in H. cbv zeta in H. rewrite !(Q2R_small (-1)), (Q2R_small 1), !Q2R_parts in H.
  apply (H eps p b y v z t He).
  + replace (1 * Rpower eps (-5 / 2 / -1)) with (Rpower eps (5 / 2)); [exact HS|].
    replace (-5 / 2 / -1) with (5 / 2) by field. ring.
  + replace (- -1 / 2) with (1 / 2) by field. exact Ht.
Qed.

Theorem zeros_4_5_checked : StatementForce.zeros_4_5_checked.
Proof.
split; [|split; [exact zeros_4_5_accepted|split; [reflexivity|]]].
- exists "ae18193e2356c2d29d03702cf4f6711d7722636ed09bc78a83b9f1b44d439d88"%string. vm_compute. reflexivity.
- intros a1 a2 a3 eps C p b y v z Hp H45 He HC HS. assert (H := force_accepted_is_true _ _ zeros_4_5_accepted).
  change (force_claimed zeros_4_5) with
    (SlowZerosClaim (Interval (At 4) (At 5) false false) 10 (3672145385 # 2147483648)) in H.
  cbn [true_force_claim] in H. rewrite (Q2R_small 10) in H. refine (H a1 a2 a3 eps C p b y v z Hp _ He HC HS).
  unfold in_range, real_range. cbn. rewrite (Q2R_small 4), (Q2R_small 5). exact H45.
Qed.

(** ** What is not true is not accepted *)
Open Scope Q_scope.

Definition right_end : list part := [Known (Sign (27 # 16) 2 true); Known (Right 2 0)].
Definition in_the_middle : list part := skipn 1 (firstn 12 (strip_parts (nth 0 (strips force_5_2) (Strip 0 0 [])))).
Definition all_line : interval := Interval MinusInfinity PlusInfinity false false.

(** The certificate of the force with other numbers, at another beta, with other pieces. *)
Definition force_with (a3 c1 eps level beta : Q) (parts : list part) : force_data :=
  ForceData (ForceClaim (-1) (-1) a3 c1 eps level all_line) [Strip beta beta parts].
Definition with_numbers (a3 c1 eps level : Q) : bool := force_accepts force_5_2_plans
  (force_with a3 c1 eps level (5 # 2) (Known (Left (-5 # 8)) :: in_the_middle ++ right_end)).
Definition with_parts (parts : list part) : bool :=
  force_accepts force_5_2_plans (force_with (-5 # 2) (-1) (4 # 5) (589 # 1000) (5 # 2) parts).

Example the_force_with_a_level_of_few_digits : with_numbers (-5 # 2) (-1) (4 # 5) (589 # 1000) = true.
Proof. vm_compute. reflexivity. Qed.

Example a_level_that_the_pieces_do_not_keep : with_numbers (-5 # 2) (-1) (4 # 5) (1 # 2) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_level_beyond_the_mean : with_numbers (-5 # 2) (-1) (4 # 5) (6 # 10) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_larger_eps : with_numbers (-5 # 2) (-1) (9 # 10) (589 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example an_eps_that_is_not_positive : with_numbers (-5 # 2) (-1) 0 (589 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example the_other_side : with_numbers (-5 # 2) 1 (4 # 5) (589 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example no_charge : with_numbers (-5 # 2) 0 (4 # 5) (589 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example another_beta_than_that_of_the_column : with_numbers (-9 # 4) (-1) (4 # 5) (589 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example beta_is_not_that_of_the_numbers : force_accepts force_5_2_plans (force_with (-5 # 2) (-1) (4 # 5) (589 # 1000)
  (9 # 4) (Known (Left (-5 # 8)) :: in_the_middle ++ right_end)) = false.
Proof. vm_compute. reflexivity. Qed.

Example an_integer_beta : force_accepts force_5_2_plans (force_with (-2) (-1) (1 # 100) (589 # 1000) 2
  (Known (Left (-5 # 8)) :: in_the_middle ++ right_end)) = false.
Proof. vm_compute. reflexivity. Qed.

Example the_pieces_with_these_numbers : with_parts (Known (Left (-5 # 8)) :: in_the_middle ++ right_end) = true.
Proof. vm_compute. reflexivity. Qed.

Example a_missing_piece : with_parts (Known (Left (-5 # 8)) :: tl in_the_middle ++ right_end) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_missing_end : with_parts (Known (Left (-5 # 8)) :: in_the_middle ++ firstn 1 right_end) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_left_end_too_near_to_0 :
  with_parts (Known (Left (-1 # 8)) :: skipn 1 in_the_middle ++ right_end) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_sign_where_there_is_none :
  with_parts (Known (Left (-5 # 8)) :: in_the_middle ++ [Known (Sign (27 # 16) 2 false); Known (Right 2 0)]) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_sign_that_is_not_that_of_the_side :
  with_parts (Known (Left (-5 # 8)) :: in_the_middle ++ [Known (Right (27 # 16) 1)]) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_sign_against_that_of_F :
  force_accepts [ForcePlan (Plan 6 5 (2 ^ 72) 0 [1; 1; 1; 1]%nat (Effort 500 1000 2 3 200)) 0 0 0 0]
    (force_with (-5 # 2) (-1) (4 # 5) (589 # 1000) (5 # 2) (Known (Left (-5 # 8)) :: firstn 7 in_the_middle ++
      [Known (Sign (3 # 4) (13 # 16) true)] ++ skipn 8 in_the_middle ++ right_end)) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_piece_dip_bounds_no_force : with_parts (Known (Left (-5 # 8)) :: in_the_middle ++
  [Dip (27 # 16) 2; Known (Right 2 0)]) = false.
Proof. vm_compute. reflexivity. Qed.

Example two_columns_of_the_force : force_accepts (force_5_2_plans ++ force_5_2_plans)
  (ForceData (force_claimed force_5_2) (strips force_5_2 ++ strips force_5_2)) = false.
Proof. vm_compute. reflexivity. Qed.

Definition lift_off_with (c1 eps level tau : Q) (parts : list part) : bool := force_accepts lift_off_5_2_plans
  (ForceData (LiftOffClaim (-1) (-1) (-5 # 2) c1 eps level tau) [Strip (5 # 2) (5 # 2) parts]).

Example a_lift_off : lift_off_with 1 (1 # 1000) (4715 # 10) (5537 # 1000) [Level (5537 # 1000) 6] = true.
Proof. vm_compute. reflexivity. Qed.

Example a_smaller_eps : lift_off_with 1 (1 # 1001) (4714 # 10) (5537 # 1000) [Level (5537 # 1000) 6] = false.
Proof. vm_compute. reflexivity. Qed.

Example a_level_that_is_not_reached : lift_off_with 1 (1 # 1000) 473 (5537 # 1000) [Level (5537 # 1000) 6] = false.
Proof. vm_compute. reflexivity. Qed.

Example an_earlier_time : lift_off_with 1 (1 # 1000) (4715 # 10) (553 # 100) [Level (553 # 100) 6] = false.
Proof. vm_compute. reflexivity. Qed.

Example a_time_outside_of_the_piece : lift_off_with 1 (1 # 1000) (4715 # 10) (5537 # 1000) [Level (5538 # 1000) 6]
  = false.
Proof. vm_compute. reflexivity. Qed.

Example no_piece_at_all : lift_off_with 1 (1 # 1000) (4715 # 10) (5537 # 1000) [] = false.
Proof. vm_compute. reflexivity. Qed.

Example the_side_that_does_not_lift_off : lift_off_with (-1) (1 # 1000) (4715 # 10) (5537 # 1000)
  [Level (5537 # 1000) 6] = false.
Proof. vm_compute. reflexivity. Qed.

(** One column of the certificate of the zeros, with two numbers around the powers. *)
Definition zeros_between (longest shortest high_range eps eta low high t1 t2 below above : Q) : bool :=
  let p := nth 60 zeros_4_5_plans (ForcePlan (Plan 1 0 1 0 [] (Effort 0 0 1 0 0)) 0 0 0 0) in
  force_accepts [ForcePlan (walk_plan p) below longest above shortest]
    (ForceData (SlowZerosClaim (Interval (At (593 # 128)) (At high_range) true true) eps eta)
      [Strip low high [Dip t1 t2]]).

Definition zeros_with := zeros_between (338 # 128) (337 # 128).

Example one_column_of_the_zeros :
  zeros_with (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = true.
Proof. vm_compute. reflexivity. Qed.

Example eta_too_small_for_eps :
  zeros_with (297 # 64) 10 (170 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example eta_so_large_that_there_is_no_dip :
  zeros_with (297 # 64) 10 3 (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example no_dip_so_near_to_0 :
  zeros_with (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (7 # 64) (9 # 64) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example points_too_near_to_each_other :
  zeros_with (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (50 # 32) (9 # 10) 1 = false.
Proof. vm_compute. reflexivity. Qed.

Example a_lower_power_too_high :
  zeros_with (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (516 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example an_upper_power_too_low :
  zeros_with (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (515 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example an_exponent_inside_of_the_column : zeros_between (675 # 256) (337 # 128)
  (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example the_other_exponent_inside_of_the_column : zeros_between (338 # 128) (675 # 256)
  (297 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_column_that_ends_too_soon :
  zeros_with (298 # 64) 10 (171 # 100) (593 # 128) (297 # 64) (49 # 32) (63 # 32) (514 # 1000) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_range_beyond_5 :
  zeros_with (11 # 2) 10 (171 # 100) (593 # 128) (11 # 2) (49 # 32) (63 # 32) (1 # 100) (517 # 1000) = false.
Proof. vm_compute. reflexivity. Qed.

Example a_gap_between_columns : force_accepts (skipn 1 zeros_4_5_plans)
  (ForceData (force_claimed zeros_4_5) (skipn 1 (strips zeros_4_5))) = false.
Proof. vm_compute. reflexivity. Qed.
