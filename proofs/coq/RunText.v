(** * The first line of a certificate of a run as data, and its text

    What stands in the first line of a file of version 4 whose scene the checker in Coq knows (proofs/certificate.md,
    "Text"; proofs/run_certificate.md), with rational numbers; [header_text] writes it as this line. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText ForceText RunScene.
Import ListNotations.
Open Scope string_scope.

(** The scene with its first event; and what the statement says beside it, of which nothing is proved here: the events
    that follow, the end of the time, whether the last contact is for ever. *)
Record header := Header { its_scene : scene; later : list (string * (Q * Q)); until : Q; for_ever : bool }.

Definition event_text (e : string * (Q * Q)) : string :=
  listed [quoted (fst e); number_text (fst (snd e)); number_text (snd (snd e))].

Definition first_event (g : scene) : string := event_text ("lift-off", (low g, high g)).

Definition parameters_text (g : scene) : string :=
  object [field "alpha_1" (number_text (alpha1 g)); field "alpha_2" (number_text (alpha2 g));
          field "beta" (number_text (beta g)); field "damping" (quoted "1"); field "k_1" (quoted "1");
          field "k_2" (quoted "1")].

Definition start_text (g : scene) : string :=
  object [field "b" (number_text (b0 g)); field "p" (number_text (p0 g)); field "v" (number_text (v0 g));
          field "y" (number_text (y0 g)); field "z" (number_text (z0 g))].

(** What is proved of a file: its scene, up to the first event. *)
Definition first_phase_text (g : scene) : string :=
  object [field "epsilon" (number_text (eps g)); field "first_event" (first_event g);
          field "parameters" (parameters_text g); field "start" (start_text g)].

Definition statement_text (h : header) : string :=
  let g := its_scene h in
  object [field "effects" (listed (map quoted ["compliant_contact"; "lift_off"]));
          field "end" (quoted (if for_ever h then "for ever" else "time")); field "epsilon" (number_text (eps g));
          field "events" (listed (first_event g :: map event_text (later h))); field "kind" (quoted "run");
          field "parameters" (parameters_text g); field "start" (start_text g); field "until" (number_text (until h))].

Definition header_text (h : header) : string :=
  object [field "format" (quoted "gspot_verified certificate");
          field "hypotheses" (listed (map quoted ["invariant_region"; "left_out_effects"; "run_certificate"]));
          field "statement" (statement_text h); field "version" "4"].
