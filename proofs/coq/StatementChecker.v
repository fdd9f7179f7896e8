(** * What is proved: a checker of certificates that runs in Coq

    This file holds no proof; [Theorems.v] proves each statement under its name. [Statement.v] says what Theta is and
    [StatementCertificate.v] what a range is. The data of a certificate and its text are in [CertificateText.v]. The
    checker itself, [accepts] and [counted] of [CheckerCertificate.v], need not be read: that it is right is what is
    stated here. The bytes of the two files are in [CertificateIWC.v] and [CertificateZeros.v]. *)

From Coq Require Import String.
From Coq Require Import Reals QArith Qreals List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate CertificateText CheckerCertificate CertificateIWC
  CertificateZeros.
Import ListNotations.
Open Scope R_scope.

(** The range with these rational ends. *)
Definition real_edge (e : edge) : Rbar :=
  match e with MinusInfinity => m_infty | At q => Finite (Q2R q) | PlusInfinity => p_infty end.

Definition real_range (r : interval) : range := Range (real_edge (interval_from r)) (real_edge (interval_to r))
  (has_from r) (has_to r).

(** What a certificate claims: a sign of dTheta/dtau on two ranges; or that for every beta of a range that is not an
    integer the number of its real zeros is the one that [counts] gives for the cell (m, m + 1) of beta, and all are
    simple. *)
Definition true_claim (F : R -> R -> R) (c : claim) : Prop :=
  match c with
  | SignClaim tau beta s => forall t b, in_range (real_range tau) t -> in_range (real_range beta) b ->
    0 < signed s (Derive (F b) t)
  | ZerosClaim beta counts => forall b, in_range (real_range beta) b -> not_nat b ->
      exists m n l, In (m, n) counts /\ INR m < b < INR m + 1 /\
        zeros_of (Derive (F b)) l /\ length l = n /\ forall t, In t l -> Derive_n (F b) 2 t <> 0
  end.

(** What the checker accepts is true. (It does not ask whether [counts] names a cell twice, or whether a range is empty:
    the format of proofs/certificate.md does, and check_in_coq.py reads a file by it.) *)
Definition certificate_checker : Prop := forall F plans c, theta_family F -> accepts plans c = true ->
  true_claim F (claimed c).

(** The number of zeros without the pieces, by the count law: what [counted] accepts is true. *)
Definition count_checker : Prop := forall F c, theta_family F -> counted c = true -> true_claim F c.

(** The characters of a file: the text of a certificate, then [sha256], anything, and a line feed. The hash is not
    computed here. *)
Definition is_file (file : string) (c : certificate) : Prop := exists hash : string,
  file = (text c ++ "sha256 " ++ hash ++ line_feed)%string.

(** The checker has run on the file proofs/iwc_0_1.cert, whose bytes are [iwc_0_1_file]; what follows from the run. *)
Definition iwc_0_1_checked : Prop := is_file iwc_0_1_file iwc_0_1 /\ accepts iwc_0_1_plans iwc_0_1 = true /\
  claimed iwc_0_1 = SignClaim (Interval MinusInfinity PlusInfinity false false) (Interval (At 0) (At 1) false false)
    false /\
  forall F t b, theta_family F -> 0 < b < 1 -> Derive (F b) t < 0.

(** And on proofs/coq/zeros_1_2.cert. *)
Definition zeros_1_2_checked : Prop := is_file zeros_1_2_file zeros_1_2 /\ accepts zeros_1_2_plans zeros_1_2 = true /\
  claimed zeros_1_2 = ZerosClaim (Interval (At 1) (At 2) false false) [(1, 1)]%nat /\
  forall F b, theta_family F -> 1 < b < 2 ->
    exists z, (forall t, Derive (F b) t = 0 <-> t = z) /\ Derive_n (F b) 2 z <> 0.
