(** * What is proved: a checker, in Coq, of certificates about the contact force

    This file holds no proof; [Theorems.v] proves each statement under its name. [StatementCompliant.v] says what the
    mechanism and its slow motions are, [StatementChecker.v] what a range with rational ends is. The data of a
    certificate and its text are in [ForceText.v]. The checker itself, [force_accepts] of [ForceChecker.v], need not be
    read: that it is right is what is stated here. The bytes of the three files are in [DataForce.v], [DataLiftOff.v]
    and [DataSlowZeros.v]. *)

From Coq Require Import String.
From Coq Require Import Reals QArith Qreals List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant StatementCertificate CertificateText StatementChecker ForceText
  ForceChecker DataForce DataLiftOff DataSlowZeros.
Import ListNotations.
Open Scope R_scope.

(** What a certificate claims, with C = C_1 eps^beta and tau = (-a1/2)^(1/3) t eps^(-2/3): on the slow motion the force
    is positive at every tau of a range and every eps up to one; or negative at one tau and every eps from one on; or,
    for every beta of a range that is not an integer and every eps up to one, it is equal to its mean exactly twice,
    and both zeros of the difference are simple (a1 = -1; in general -a1 eps is in the place of eps). *)
Definition true_force_claim (c : force_claim) : Prop :=
  match c with
  | ForceClaim q1 q2 q3 qC eps0 _ tau => let a1 := Q2R q1 in let a2 := Q2R q2 in let a3 := Q2R q3 in
      forall eps p b y v z t, 0 < eps <= Q2R eps0 ->
        slow_motion a1 a2 a3 eps (Q2R qC * Rpower eps (a3 / a1)) p b y v z ->
        in_range (real_range tau) (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) ->
        0 < linear_force eps (y t) (z t)
  | LiftOffClaim q1 q2 q3 qC eps1 _ tau => let a1 := Q2R q1 in let a2 := Q2R q2 in let a3 := Q2R q3 in
      forall eps p b y v z t, Q2R eps1 <= eps ->
        slow_motion a1 a2 a3 eps (Q2R qC * Rpower eps (a3 / a1)) p b y v z ->
        Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) = Q2R tau ->
        linear_force eps (y t) (z t) < 0
  | SlowZerosClaim beta eps0 _ => forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
        in_range (real_range beta) (a3 / a1) -> - a1 * eps <= Q2R eps0 -> C <> 0 ->
        slow_motion a1 a2 a3 eps C p b y v z ->
        exists s t, s < t /\ simple_zeros (fun t => linear_force eps (y t) (z t) - a2 / (a3 - a1)) [s; t]
  end.

(** What the checker accepts is true. *)
Definition force_checker : Prop := forall plans c, force_accepts plans c = true -> true_force_claim (force_claimed c).

(** The characters of a file: the text of a certificate, then [sha256], anything, and a line feed. *)
Definition is_force_file (file : string) (c : force_data) : Prop := exists hash : string,
  file = (force_text c ++ "sha256 " ++ hash ++ line_feed)%string.

(** The checker has run on the file proofs/force_5_2.cert, whose bytes are [force_5_2_file]; what follows. *)
Definition force_5_2_checked : Prop := is_force_file force_5_2_file force_5_2 /\
  force_accepts force_5_2_plans force_5_2 = true /\
  force_claimed force_5_2 = ForceClaim (-1) (-1) (-5 # 2) (-1) (4 # 5) (5892556509887 # 10000000000000)
    (Interval MinusInfinity PlusInfinity false false) /\
  forall eps p b y v z, 0 < eps <= 4 / 5 -> slow_motion (-1) (-1) (-5 / 2) eps (- Rpower eps (5 / 2)) p b y v z ->
    forall t, 0 < linear_force eps (y t) (z t).

(** And on proofs/lift_off_5_2.cert. *)
Definition lift_off_5_2_checked : Prop := is_force_file lift_off_5_2_file lift_off_5_2 /\
  force_accepts lift_off_5_2_plans lift_off_5_2 = true /\
  force_claimed lift_off_5_2 = LiftOffClaim (-1) (-1) (-5 # 2) 1 (1 # 1000) (4714045207911 # 10000000000)
    (5537 # 1000) /\
  forall eps p b y v z t, 1 / 1000 <= eps -> slow_motion (-1) (-1) (-5 / 2) eps (Rpower eps (5 / 2)) p b y v z ->
    Rpower (1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) = 5537 / 1000 -> linear_force eps (y t) (z t) < 0.

(** And on proofs/zeros_4_5.cert. *)
Definition zeros_4_5_checked : Prop := is_force_file zeros_4_5_file zeros_4_5 /\
  force_accepts zeros_4_5_plans zeros_4_5 = true /\
  force_claimed zeros_4_5 = SlowZerosClaim (Interval (At 4) (At 5) false false) 10 (3672145385 # 2147483648) /\
  forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps -> 4 < a3 / a1 < 5 -> - a1 * eps <= 10 -> C <> 0 ->
    slow_motion a1 a2 a3 eps C p b y v z ->
    exists s t, s < t /\ simple_zeros (fun t => linear_force eps (y t) (z t) - a2 / (a3 - a1)) [s; t].
