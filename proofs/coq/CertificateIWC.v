(** * The certificate iwc_0_1.cert

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate.
Import ListNotations.
Open Scope Q_scope.

Definition iwc_0_1_file : string := "{""format"":""gspot_verified certificate"",""hypotheses"":[""certificate"",""fold"",""identities"",""initial_values"",""laplace"",""negative"",""tails""],""statement"":{""beta"":""(0, 1)"",""kind"":""sign"",""sign"":-1,""tau"":""(-inf, inf)""},""version"":1}
{""beta"":[""0"",""1/4""],""pieces"":[[""left"",""-81/64""],[""sign"",""-81/64"",""-1"",1],[""sign"",""-1"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""taylor""]]}
{""beta"":[""1/4"",""1/2""],""pieces"":[[""left"",""-69/64""],[""sign"",""-69/64"",""-1"",1],[""sign"",""-1"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""taylor""]]}
{""beta"":[""1/2"",""3/4""],""pieces"":[[""left"",""-55/64""],[""sign"",""-55/64"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""taylor""]]}
{""beta"":[""3/4"",""1""],""pieces"":[[""left"",""-5/8""],[""sign"",""-5/8"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""taylor""]]}
sha256 4e010080ce0749605ae9a0a8f9f0821463091a8e44c11d40d2263fd188686045
"%string.

Definition iwc_0_1 : certificate := Certificate (SignClaim (Interval MinusInfinity PlusInfinity false false) (Interval (At (0 # 1)) (At (1 # 1)) false false) false)
  [Block (At (0 # 1)) (1 # 4)
     [Left ((-81) # 64); Sign ((-81) # 64) ((-1) # 1) true; Sign ((-1) # 1) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Taylor];
   Block (At (1 # 4)) (1 # 2)
     [Left ((-69) # 64); Sign ((-69) # 64) ((-1) # 1) true; Sign ((-1) # 1) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Taylor];
   Block (At (1 # 2)) (3 # 4)
     [Left ((-55) # 64); Sign ((-55) # 64) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Taylor];
   Block (At (3 # 4)) (1 # 1)
     [Left ((-5) # 8); Sign ((-5) # 8) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Taylor]].

Definition iwc_0_1_plans : list plan :=
  [Plan 6 5 (2 ^ 64) 4 [9; 5; 5; 5]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [9; 6; 6; 6]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [9; 6; 6; 6]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [9; 6; 6; 6]%nat (Effort 500 1000 2 8 200)].
