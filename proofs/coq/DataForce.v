(** * The certificate force_5_2.cert

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate ForceText ForceChecker.
Import ListNotations.
Open Scope Q_scope.

Definition force_5_2_file : string := "{""format"":""gspot_verified certificate"",""hypotheses"":[""certificate"",""exact_solution"",""identities"",""initial_values"",""laplace"",""monotone"",""negative"",""tails""],""statement"":{""alpha"":[""-1"",""-1"",""-5/2""],""c1"":""-1"",""epsilon"":""4/5"",""kind"":""force"",""level"":""5892556509887/10000000000000"",""tau"":""(-inf, inf)""},""version"":2}
{""beta"":[""5/2"",""5/2""],""pieces"":[[""left"",""-5/8""],[""level"",""-5/8"",""-1/8""],[""level"",""-1/8"",""1/8""],[""level"",""1/8"",""3/8""],[""level"",""3/8"",""1/2""],[""level"",""1/2"",""5/8""],[""level"",""5/8"",""11/16""],[""level"",""11/16"",""3/4""],[""level"",""3/4"",""13/16""],[""level"",""13/16"",""15/16""],[""level"",""15/16"",""19/16""],[""level"",""19/16"",""27/16""],[""sign"",""27/16"",""2"",1],[""right"",""2"",0]]}
sha256 a14b2ee31e8df8c99f1c47c4510400d52bb9a2985afacdf72460fcb13b546886
"%string.

Definition force_5_2 : force_data := ForceData (ForceClaim ((-1) # 1) ((-1) # 1) ((-5) # 2) ((-1) # 1) (4 # 5) (5892556509887 # 10000000000000) (Interval MinusInfinity PlusInfinity false false))
  [Strip (5 # 2) (5 # 2)
     [Known (Left ((-5) # 8)); Level ((-5) # 8) ((-1) # 8); Level ((-1) # 8) (1 # 8); Level (1 # 8) (3 # 8); Level (3 # 8) (1 # 2); Level (1 # 2) (5 # 8); Level (5 # 8) (11 # 16); Level (11 # 16) (3 # 4); Level (3 # 4) (13 # 16); Level (13 # 16) (15 # 16); Level (15 # 16) (19 # 16); Level (19 # 16) (27 # 16); Known (Sign (27 # 16) (2 # 1) true); Known (Right (2 # 1) 0)]].

Definition force_5_2_plans : list force_plan :=
  [ForcePlan (Plan 6 5 (2 ^ 72) 4 [1; 1; 1; 1]%nat (Effort 500 1000 2 8 200)) 0 0 0 0].
