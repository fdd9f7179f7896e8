(** * What is proved: a checker, in Coq, of the first phase of a run

    This file holds no proof; [Theorems.v] proves each statement under its name. [StatementCompliant.v] says what the
    equations of the mechanism and the contact force are, [StatementFlight.v] what lift-off is. The scene of a run is in
    [RunScene.v]. The checker itself, [run_accepted] of [RunChecker.v], and the steps that it judges, [DataRun.v],
    written from the file proofs/run_fig_varsim1.cert, need not be read: that what it accepts is true is what is stated
    here. *)

From Coq Require Import Reals QArith Qreals.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight RunScene RunChecker DataRun.
Open Scope R_scope.

(** A motion of the mechanism (with compl2) from this state at t = 0 on. *)
Definition starts (a1 a2 a3 eps p0 b0 y0 v0 z0 : R) (p b y v z : R -> R) : Prop :=
  mechanism_from a1 a2 a3 eps 0 p b y v z /\ p 0 = p0 /\ b 0 = b0 /\ y 0 = y0 /\ v 0 = v0 /\ z 0 = z0.

(** The contact force is positive up to a time between two numbers, and at this time comes lift-off. *)
Definition first_lift_off (eps early late : R) (y v z : R -> R) : Prop :=
  exists t1, 0 < t1 /\ early < t1 < late /\ (forall t, 0 <= t < t1 -> 0 < contact_force eps (y t) (z t)) /\
    lift_off_at eps y v z t1.

(** What a run with this scene claims of its first phase. *)
Definition true_run_claim (g : scene) : Prop :=
  let from := starts (Q2R (alpha1 g)) (Q2R (alpha2 g)) (Q2R (alpha1 g * beta g)) (Q2R (eps g))
    (Q2R (p0 g)) (Q2R (b0 g)) (Q2R (y0 g)) (Q2R (v0 g)) (Q2R (z0 g)) in
  (exists p b y v z, from p b y v z) /\
  forall p b y v z, from p b y v z -> first_lift_off (Q2R (eps g)) (Q2R (low g)) (Q2R (high g)) y v z.

(** What the checker accepts is true. *)
Definition run_checker : Prop := forall r g, run_accepted r g = true -> true_run_claim g.

(** The checker has run on the first phase of proofs/run_fig_varsim1.cert; what follows: the motion from p = 1/2, b =
    -2, y = -1/125000, v = 0, z = -1/250000 exists, keeps contact, and lifts off within 3 10^-33 after t =
    0.535370832662700. *)
Definition run_fig_varsim1_checked : Prop :=
  run_accepted run_fig_varsim1 run_fig_varsim1_scene = true /\
  let from := starts (-1) (-1) (-3 / 2) (1 / 1000) (1 / 2) (-2) (-1 / 125000) 0 (-1 / 250000) in
  (exists p b y v z, from p b y v z) /\
  forall p b y v z, from p b y v z -> first_lift_off (1 / 1000)
    (26768541633135015082986594719272279 / 50000000000000000000000000000000000)
    (66921354082837537707466486798181 / 125000000000000000000000000000000) y v z.
