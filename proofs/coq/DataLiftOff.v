(** * The certificate lift_off_5_2.cert

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate ForceText ForceChecker.
Import ListNotations.
Open Scope Q_scope.

Definition lift_off_5_2_file : string := "{""format"":""gspot_verified certificate"",""hypotheses"":[""certificate"",""exact_solution"",""identities"",""initial_values"",""laplace"",""monotone"",""negative"",""tails""],""statement"":{""alpha"":[""-1"",""-1"",""-5/2""],""c1"":""1"",""epsilon"":""1/1000"",""kind"":""lift_off"",""level"":""4714045207911/10000000000"",""tau"":""5537/1000""},""version"":2}
{""beta"":[""5/2"",""5/2""],""pieces"":[[""level"",""5537/1000"",""6537/1000""]]}
sha256 82c0e9f716332b7adfac9412b11cdbd590b91f9f581741aa3bc2dbe1724d45bf
"%string.

Definition lift_off_5_2 : force_data := ForceData (LiftOffClaim ((-1) # 1) ((-1) # 1) ((-5) # 2) (1 # 1) (1 # 1000) (4714045207911 # 10000000000) (5537 # 1000))
  [Strip (5 # 2) (5 # 2)
     [Level (5537 # 1000) (6537 # 1000)]].

Definition lift_off_5_2_plans : list force_plan :=
  [ForcePlan (Plan 8 8 (2 ^ 88) 4 [1; 1; 1; 1]%nat (Effort 500 1000 2 8 200)) 0 0 0 0].
