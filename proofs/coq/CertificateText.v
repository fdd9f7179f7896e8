(** * A certificate as data, and its text

    What stands in a file of a certificate of version 1 (proofs/certificate.md, "Text"), with rational numbers; [text]
    writes it as the lines of the file, all but the last one, the hash. *)

From Coq Require Import ZArith QArith List String Ascii DecimalString.
Import ListNotations.
Open Scope string_scope.

Inductive edge := MinusInfinity | At (q : Q) | PlusInfinity.

Record interval := Interval { interval_from : edge; interval_to : edge; has_from : bool; has_to : bool }.

Inductive entry :=
| Laplace | Taylor | Left (X : Q) | Sign (t1 t2 : Q) (s : bool)
| Monotone (t1 t2 : Q) (d : bool) | Fold (t1 t2 : Q) | Hinge (t1 t2 : Q) | Right (T : Q) (v : nat).

Record block := Block { beta_from : edge; beta_to : Q; entries : list entry }.

Inductive claim :=
| SignClaim (tau beta : interval) (s : bool)
| ZerosClaim (beta : interval) (counts : list (nat * nat)).

Record certificate := Certificate { claimed : claim; blocks : list block }.

(** ** The text *)
Definition quote : string := String (ascii_of_nat 34) "".
Definition line_feed : string := String (ascii_of_nat 10) "".
Definition quoted (s : string) : string := quote ++ s ++ quote.
Definition joined (separator : string) (l : list string) : string := concat separator l.
Definition listed (l : list string) : string := "[" ++ joined "," l ++ "]".
Definition field (name value : string) : string := quoted name ++ ":" ++ value.
Definition object (l : list string) : string := "{" ++ joined "," l ++ "}".

Definition integer (z : Z) : string := NilZero.string_of_int (Z.to_int z).

Definition rational (q : Q) : string :=
  match Qden q with
  | 1%positive => integer (Qnum q)
  | d => integer (Qnum q) ++ "/" ++ integer (Zpos d)
  end.

Definition edge_text (e : edge) : string :=
  match e with MinusInfinity => "-inf" | At q => rational q | PlusInfinity => "inf" end.

Definition interval_text (r : interval) : string :=
  quoted ((if has_from r then "[" else "(") ++ edge_text (interval_from r) ++ ", " ++ edge_text (interval_to r)
    ++ (if has_to r then "]" else ")")).

Definition plus_or_minus (s : bool) : string := if s then "1" else "-1".

Definition entry_text (p : entry) : string :=
  let points l := map (fun q => quoted (rational q)) l in
  listed
    match p with
    | Laplace => [quoted "laplace"]
    | Taylor => [quoted "taylor"]
    | Left X => quoted "left" :: points [X]
    | Sign t1 t2 s => quoted "sign" :: points [t1; t2] ++ [plus_or_minus s]
    | Monotone t1 t2 d => quoted "monotone" :: points [t1; t2] ++ [plus_or_minus d]
    | Fold t1 t2 => quoted "fold" :: points [t1; t2]
    | Hinge t1 t2 => quoted "hinge" :: points [t1; t2]
    | Right T v => quoted "right" :: points [T] ++ [integer (Z.of_nat v)]
    end.

Definition block_text (c : block) : string :=
  object [field "beta" (listed [quoted (edge_text (beta_from c)); quoted (rational (beta_to c))]);
          field "pieces" (listed (map entry_text (entries c)))] ++ line_feed.

Definition claim_text (c : claim) : string :=
  object
    match c with
    | SignClaim tau beta s =>
        [field "beta" (interval_text beta); field "kind" (quoted "sign"); field "sign" (plus_or_minus s);
          field "tau" (interval_text tau)]
    | ZerosClaim beta counts =>
        [field "beta" (interval_text beta);
         field "counts" (listed (map (fun e => listed [integer (Z.of_nat (fst e)); integer (Z.of_nat (snd e))])
           counts));
         field "kind" (quoted "zeros")]
    end.

Definition pages : list string := ["certificate"; "fold"; "identities"; "initial_values"; "laplace"; "negative";
  "tails"].

Definition text (c : certificate) : string :=
  object [field "format" (quoted "gspot_verified certificate"); field "hypotheses" (listed (map quoted pages));
          field "statement" (claim_text (claimed c)); field "version" "1"] ++ line_feed
  ++ joined "" (map block_text (blocks c)).
