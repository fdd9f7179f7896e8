(** * What is proved about the mechanism after lift-off: definitions and statements

    This file holds no proof; it is read after [StatementCompliant.v], whose words it uses. Each statement is proved in
    [Theorems.v] under the same name. The page is proofs/flight.md, in the normal form a1 = -1; here a1, a2, a3 and eps
    > 0 are arbitrary where nothing is said. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant.
Open Scope R_scope.

(** A motion of the mechanism (with compl2) from t0 on. By [motion_exists] there is one from every state, by
    [motion_unique] only one. *)
Definition mechanism_from (a1 a2 a3 eps t0 : R) (p b y v z : R -> R) : Prop :=
  forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.

(** ** Flights *)

(** The derivative of y - z where the force is 0. *)
Definition separation_rate (eps v z : R) : R := v + z / eps.

(** Lift-off at t: y = z, and y - z increases. *)
Definition lift_off_at (eps : R) (y v z : R -> R) (t : R) : Prop := y t = z t /\ 0 < separation_rate eps (v t) (z t).

(** Touch-down at t: y = z, y - z decreases, and contact follows. *)
Definition touch_down_at (eps : R) (y v z : R -> R) (t : R) : Prop :=
  y t = z t /\ separation_rate eps (v t) (z t) < 0 /\ exists d, 0 < d /\ forall s, t < s < t + d -> y s < z s.

(** The motion without contact force, in the time u since t0. *)
Definition in_flight (a2 eps t0 t : R) (b y v z : R -> R) : Prop :=
  let u := t - t0 in
  b t = b t0 + a2 * u /\ v t = v t0 + b t0 * u + a2 * u ^ 2 / 2 /\
  y t = y t0 + v t0 * u + b t0 * u ^ 2 / 2 + a2 * u ^ 3 / 6 /\ z t = z t0 * exp (- u / eps).

(** z <= 0 at one time: ever after. The theorems on flights suppose it. *)
Definition z_stays_nonpositive : Prop := forall a1 a2 a3 eps t0 p b y v z, 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> z t0 <= 0 -> forall t, t0 <= t -> z t <= 0.

(** With a2 < 0 (or a2 = 0 and b < 0) the flight after a lift-off ends: a touch-down follows. (Of what comes later
    nothing is said.) *)
Definition flight_ends : Prop := forall a1 a2 a3 eps t0 p b y v z, 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 -> a2 < 0 \/ a2 = 0 /\ b t0 < 0 ->
  exists t1, t0 < t1 /\ (forall t, t0 < t < t1 -> z t < y t) /\
    (forall t, t0 <= t <= t1 -> in_flight a2 eps t0 t b y v z) /\
    touch_down_at eps y v z t1.

(** With a2 >= 0 and b >= 0 it never ends. *)
Definition flight_never_ends : Prop := forall a1 a2 a3 eps t0 p b y v z, 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 -> 0 <= a2 -> 0 <= b t0 ->
  forall t, t0 < t -> z t < y t /\ in_flight a2 eps t0 t b y v z.

(** Case II (a2 > 0): b, v and y increase in such a flight. *)
Definition flight_persists : Prop := forall a1 a2 a3 eps t0 p b y v z, 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 -> 0 < a2 -> 0 <= b t0 ->
  forall s t, t0 <= s -> s < t -> z t < y t /\ b s < b t /\ v s < v t /\ y s < y t.

(** Case III (a2 < 0), 1 < beta < 2, C on the side of lift-off: the motion of the mechanism from a state in contact of
    the slow motion lifts off, with z <= 0, flies, and touches down. *)
Definition slow_flight : Prop := forall a1 a2 a3 eps C t0 P B Y V Z p b y v z, parameters a1 a3 eps ->
  1 < a3 / a1 < 2 -> C < 0 -> a2 < 0 -> slow_motion a1 a2 a3 eps C P B Y V Z -> Y t0 < Z t0 ->
  mechanism_from a1 a2 a3 eps t0 p b y v z ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  exists t1 t2, t0 < t1 < t2 /\ (forall t, t0 <= t < t1 -> y t < z t) /\ lift_off_at eps y v z t1 /\ z t1 <= 0 /\
    (forall t, t1 < t < t2 -> z t < y t) /\ touch_down_at eps y v z t2.

(** ** Contacts that last for ever *)

(** Impact without collision from t0 on: contact is never lost, the force tends to +oo and y to -oo. *)
Definition contact_for_ever (eps t0 : R) (y z : R -> R) : Prop :=
  (forall t, t0 < t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** The force in contact, eps times its derivative, and -(b + p lambda), minus the normal acceleration. *)
Definition force_rate (eps y v z : R) : R := (y - 2 * z - eps * v) / eps ^ 2.
Definition deceleration (eps p b y z : R) : R := - (b + p * linear_force eps y z).

(** beta <= 1, a2 <= 0, p <= 0: a state in contact with v <= 0, b + p lambda <= 0 and an increasing force. *)
Definition growth_below_one : Prop := forall a1 a2 a3 eps t0 p b y v z, a1 < 0 -> a1 <= a3 -> a2 <= 0 -> 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> p t0 <= 0 -> y t0 <= z t0 -> v t0 <= 0 ->
  0 <= deceleration eps (p t0) (b t0) (y t0) (z t0) -> 0 < force_rate eps (y t0) (v t0) (z t0) ->
    contact_for_ever eps t0 y z.

(** beta > 1, a > 0 and q = - p >= kappa/a + 2a + a^2, kappa = eps (a1 - a3): a set of states whose contact lasts for
    ever. *)
Definition growth_above_one : Prop := forall a1 a2 a3 eps a t0 p b y v z, a1 < 0 -> a3 < a1 -> a2 <= 0 -> 0 < eps ->
  0 < a ->
  mechanism_from a1 a2 a3 eps t0 p b y v z ->
  let lambda := linear_force eps (y t0) (z t0) in
  let G := deceleration eps (p t0) (b t0) (y t0) (z t0) in
  let D := force_rate eps (y t0) (v t0) (z t0) in
  eps * (a1 - a3) / a + 2 * a + a ^ 2 <= - p t0 -> 0 <= lambda -> v t0 <= 0 -> 0 <= G -> a * lambda <= D ->
  a * (2 + a) * lambda <= - v t0 / eps + G -> 0 < D -> contact_for_ever eps t0 y z.

(** A flight from t0 to t1. *)
Definition flight_from_to (y z : R -> R) (t0 t1 : R) : Prop := t0 < t1 /\ (forall t, t0 < t < t1 -> z t < y t) /\
  y t1 = z t1.

(** A touch-down that is late enough is the last event, whatever the state at lift-off (z <= 0): contact lasts for ever
    after it. For beta <= 1 a flight of 2 eps is late enough if p <= 0 at touch-down; for beta > 1 one of 4 eps, with
    two inequalities between its length and - p at touch-down (the second one holds for u >= 4 as soon as kappa (u + 2)
    <= 4). *)
Definition late_touch_down_below_one : Prop := forall a1 a2 a3 eps t0 t1 p b y v z, a1 < 0 -> a1 <= a3 -> a2 < 0 ->
  0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 -> flight_from_to y z t0 t1 ->
  2 * eps <= t1 - t0 -> p t1 <= 0 -> contact_for_ever eps t1 y z.

Definition late_touch_down : Prop := forall a1 a2 a3 eps t0 t1 p b y v z, a1 < 0 -> a3 < a1 -> a2 < 0 -> 0 < eps ->
  mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 -> flight_from_to y z t0 t1 ->
  let u := (t1 - t0) / eps in
  let kappa := eps * (a1 - a3) in
  4 <= u -> kappa * (u + 2) / 2 + 16 / (u * (u + 2)) <= - p t1 ->
  kappa * (u + 2) / 2 + 4 / (u + 2) + 4 / (u + 2) ^ 2 + 24 / (u * (u + 4)) <= 4 -> contact_for_ever eps t1 y z.

(** Theorem F6 of flight.md from the state at lift-off on (1 < beta <= 3; q = - p, kappa = eps (a1 - a3), the force at
    the mean a2/(a3 - a1)): what its Lemmas 1 and 2 find at the lift-off of a slow motion is supposed of b and v here.
    There is exactly one flight, and the contact after it lasts for ever. *)
Definition one_flight_from_state : Prop := forall a1 a2 a3 eps t0 p b y v z, a1 < 0 -> 3 * a1 <= a3 -> a3 < a1 ->
  a2 < 0 -> 0 < eps -> mechanism_from a1 a2 a3 eps t0 p b y v z -> lift_off_at eps y v z t0 -> z t0 <= 0 ->
  let kappa := eps * (a1 - a3) in let q := - p t0 in let mean := a2 / (a3 - a1) in
  0 < q -> 64 * kappa ^ 2 <= q ^ 3 -> kappa <= 27 / 64 -> 27 / 2 * q + sqrt (18 * kappa * sqrt q) + 2 * kappa <= 4 ->
  q * mean / 4 <= b t0 -> b t0 <= 9 / 2 * q * mean -> v t0 / eps <= 3 * sqrt q * mean ->
  exists t1, t0 < t1 /\ (forall t, t0 < t < t1 -> z t < y t) /\ touch_down_at eps y v z t1 /\
    contact_for_ever eps t1 y z.
