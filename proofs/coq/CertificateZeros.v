(** * The certificate zeros_1_2.cert

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate.
Import ListNotations.
Open Scope Q_scope.

Definition zeros_1_2_file : string := "{""format"":""gspot_verified certificate"",""hypotheses"":[""certificate"",""fold"",""identities"",""initial_values"",""laplace"",""negative"",""tails""],""statement"":{""beta"":""(1, 2)"",""counts"":[[1,1]],""kind"":""zeros""},""version"":1}
{""beta"":[""1"",""17/16""],""pieces"":[[""left"",""-3/8""],[""sign"",""-3/8"",""0"",1],[""sign"",""0"",""1/2"",1],[""right"",""1/2"",1]]}
{""beta"":[""17/16"",""5/4""],""pieces"":[[""left"",""-5/8""],[""sign"",""-5/8"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""sign"",""0"",""1/2"",1],[""sign"",""1/2"",""1"",1],[""sign"",""1"",""5/4"",1],[""monotone"",""5/4"",""3/2"",-1],[""monotone"",""3/2"",""7/4"",-1],[""monotone"",""7/4"",""2"",-1],[""monotone"",""2"",""9/4"",-1],[""monotone"",""9/4"",""5/2"",-1],[""monotone"",""5/2"",""11/4"",-1],[""monotone"",""11/4"",""3"",-1],[""right"",""3"",0]]}
{""beta"":[""5/4"",""3/2""],""pieces"":[[""left"",""-5/8""],[""sign"",""-5/8"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""sign"",""0"",""1/2"",1],[""monotone"",""1/2"",""1"",-1],[""monotone"",""1"",""3/2"",-1],[""right"",""3/2"",0]]}
{""beta"":[""3/2"",""7/4""],""pieces"":[[""left"",""-5/8""],[""sign"",""-5/8"",""-1/2"",1],[""sign"",""-1/2"",""0"",1],[""monotone"",""0"",""1/2"",-1],[""monotone"",""1/2"",""1"",-1],[""right"",""1"",0]]}
{""beta"":[""7/4"",""31/16""],""pieces"":[[""left"",""-1/2""],[""sign"",""-1/2"",""0"",1],[""monotone"",""0"",""1/2"",-1],[""right"",""1/2"",0]]}
{""beta"":[""31/16"",""2""],""pieces"":[[""left"",""-3/8""],[""monotone"",""-3/8"",""0"",-1],[""monotone"",""0"",""1/2"",-1],[""right"",""1/2"",0]]}
sha256 52d63bf5b21fb31fd2d0a1116b5517bfebb67cf404691f011f68d309ae8b0817
"%string.

Definition zeros_1_2 : certificate := Certificate (ZerosClaim (Interval (At (1 # 1)) (At (2 # 1)) false false) [(1, 1)%nat])
  [Block (At (1 # 1)) (17 # 16)
     [Left ((-3) # 8); Sign ((-3) # 8) (0 # 1) true; Sign (0 # 1) (1 # 2) true; Right (1 # 2) 1];
   Block (At (17 # 16)) (5 # 4)
     [Left ((-5) # 8); Sign ((-5) # 8) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Sign (0 # 1) (1 # 2) true; Sign (1 # 2) (1 # 1) true; Sign (1 # 1) (5 # 4) true; Monotone (5 # 4) (3 # 2) false; Monotone (3 # 2) (7 # 4) false; Monotone (7 # 4) (2 # 1) false; Monotone (2 # 1) (9 # 4) false; Monotone (9 # 4) (5 # 2) false; Monotone (5 # 2) (11 # 4) false; Monotone (11 # 4) (3 # 1) false; Right (3 # 1) 0];
   Block (At (5 # 4)) (3 # 2)
     [Left ((-5) # 8); Sign ((-5) # 8) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Sign (0 # 1) (1 # 2) true; Monotone (1 # 2) (1 # 1) false; Monotone (1 # 1) (3 # 2) false; Right (3 # 2) 0];
   Block (At (3 # 2)) (7 # 4)
     [Left ((-5) # 8); Sign ((-5) # 8) ((-1) # 2) true; Sign ((-1) # 2) (0 # 1) true; Monotone (0 # 1) (1 # 2) false; Monotone (1 # 2) (1 # 1) false; Right (1 # 1) 0];
   Block (At (7 # 4)) (31 # 16)
     [Left ((-1) # 2); Sign ((-1) # 2) (0 # 1) true; Monotone (0 # 1) (1 # 2) false; Right (1 # 2) 0];
   Block (At (31 # 16)) (2 # 1)
     [Left ((-3) # 8); Monotone ((-3) # 8) (0 # 1) false; Monotone (0 # 1) (1 # 2) false; Right (1 # 2) 0]].

Definition zeros_1_2_plans : list plan :=
  [Plan 6 5 (2 ^ 64) 4 [6; 4; 4; 4]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 72) 4 [9; 5; 5; 5]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [10; 6; 6; 6]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [10; 6; 6; 6]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [9; 5; 5; 5]%nat (Effort 500 1000 2 8 200);
   Plan 6 5 (2 ^ 64) 4 [7; 4; 4; 4]%nat (Effort 500 1000 2 8 200)].
