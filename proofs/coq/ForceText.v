(** * A certificate about the contact force as data, and its text

    What stands in a file of a certificate of version 2 or 3 (proofs/certificate.md, "Text"), with rational numbers;
    [force_text] writes it as the lines of the file, all but the last one, the hash. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText.
Import ListNotations.
Open Scope string_scope.

(** A piece of version 1, or one of the two that bound the size of F. *)
Inductive part := Known (p : entry) | Level (t1 t2 : Q) | Dip (t1 t2 : Q).

(** A column. *)
Record strip := Strip { strip_from : Q; strip_to : Q; strip_parts : list part }.

Inductive force_claim :=
| ForceClaim (a1 a2 a3 c1 eps level : Q) (tau : interval)
| LiftOffClaim (a1 a2 a3 c1 eps level tau : Q)
| SlowZerosClaim (beta : interval) (eps eta : Q).

Record force_data := ForceData { force_claimed : force_claim; strips : list strip }.

(** ** The text *)
Definition number_text (q : Q) : string := quoted (rational q).

Definition part_text (p : part) : string :=
  match p with
  | Known p => entry_text p
  | Level t1 t2 => listed [quoted "level"; number_text t1; number_text t2]
  | Dip t1 t2 => listed [quoted "dip"; number_text t1; number_text t2]
  end.

Definition strip_text (c : strip) : string :=
  object [field "beta" (listed [number_text (strip_from c); number_text (strip_to c)]);
          field "pieces" (listed (map part_text (strip_parts c)))] ++ line_feed.

Definition system_text (a1 a2 a3 c1 eps : Q) (kind : string) (level : Q) (tau : string) : string :=
  object [field "alpha" (listed (map number_text [a1; a2; a3])); field "c1" (number_text c1);
          field "epsilon" (number_text eps); field "kind" (quoted kind); field "level" (number_text level);
          field "tau" tau].

Definition force_claim_text (c : force_claim) : string :=
  match c with
  | ForceClaim a1 a2 a3 c1 eps level tau => system_text a1 a2 a3 c1 eps "force" level (interval_text tau)
  | LiftOffClaim a1 a2 a3 c1 eps level tau => system_text a1 a2 a3 c1 eps "lift_off" level (number_text tau)
  | SlowZerosClaim beta eps eta =>
      object [field "beta" (interval_text beta); field "epsilon" (number_text eps); field "eta" (number_text eta);
              field "kind" (quoted "slow_zeros")]
  end.

Definition force_version (c : force_claim) : string :=
  match c with SlowZerosClaim _ _ _ => "3" | _ => "2" end.

Definition force_pages (c : force_claim) : list string :=
  match c with
  | SlowZerosClaim _ _ _ => ["certificate"; "epsilon_series"; "exact_solution"; "finite_epsilon_zeros"; "identities";
      "initial_values"; "laplace"; "negative"]
  | _ => ["certificate"; "exact_solution"; "identities"; "initial_values"; "laplace"; "monotone"; "negative"; "tails"]
  end.

Definition force_text (c : force_data) : string :=
  let claimed := force_claimed c in
  object [field "format" (quoted "gspot_verified certificate");
          field "hypotheses" (listed (map quoted (force_pages claimed)));
          field "statement" (force_claim_text claimed); field "version" (force_version claimed)] ++ line_feed
  ++ joined "" (map strip_text (strips c)).
