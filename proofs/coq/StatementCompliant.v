(** * What is proved about the mechanism at every eps > 0: definitions and statements

    This file holds no proof; it is read after [Statement.v], whose words it uses. Each statement is proved in
    [Theorems.v] under the same name. Labels such as modelsys1 are those of the paper. *)

From Coq Require Import Reals List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement.
Import ListNotations.
Open Scope R_scope.

(** ** The compliant model at every eps > 0 *)

(** The contact force compl2: lambda = (z - y)/eps^2 while y < z, otherwise 0; and the same without the condition. *)
Definition contact_force (eps y z : R) : R := if Rlt_dec y z then (z - y) / eps ^ 2 else 0.
Definition linear_force (eps y z : R) : R := (z - y) / eps ^ 2.

(** The equations modelsys1-modelsys5 at time t, for a law of force. *)
Definition model_at (a1 a2 a3 eps : R) (force : R -> R -> R -> R) (p b y v z : R -> R) (t : R) : Prop :=
  is_derive p t a1 /\
  is_derive b t (a2 - a3 * force eps (y t) (z t)) /\
  is_derive y t (v t) /\
  is_derive v t (b t + p t * force eps (y t) (z t)) /\
  is_derive (fun s => eps * z s) t (- z t - eps ^ 2 * force eps (y t) (z t)).

(** Through every state at every time there is exactly one motion of the mechanism (with compl2), on the whole line; and
    exactly one of the contact equations. *)
Definition motion_exists : Prop := forall force a1 a2 a3 eps t0 p0 b0 y0 v0 z0,
  force = contact_force \/ force = linear_force ->
  0 < eps -> exists p b y v z,
  (forall t, model_at a1 a2 a3 eps force p b y v z t) /\ p t0 = p0 /\ b t0 = b0 /\ y t0 = y0 /\ v t0 = v0 /\ z t0 = z0.

Definition motion_unique : Prop := forall force a1 a2 a3 eps lo t0 hi p b y v z p' b' y' v' z',
  force = contact_force \/ force = linear_force ->
  0 < eps -> lo <= t0 <= hi ->
  (forall t, lo <= t <= hi -> model_at a1 a2 a3 eps force p b y v z t) ->
  (forall t, lo <= t <= hi -> model_at a1 a2 a3 eps force p' b' y' v' z' t) ->
  p t0 = p' t0 -> b t0 = b' t0 -> y t0 = y' t0 -> v t0 = v' t0 -> z t0 = z' t0 ->
  forall t, lo <= t <= hi -> p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.

(** What all statements below suppose. beta = a3/a1; the G-spot is passed at t = 0. *)
Definition parameters (a1 a3 eps : R) : Prop := a1 < 0 /\ a3 < 0 /\ 0 < eps /\ not_nat (a3 / a1).

(** A motion on the slow manifold with coefficient C: it solves the contact equations for all t, p = a1 t, and
    b - (its trivial part) ~ C (-t/eps)^beta as t -> -oo. *)
Definition slow_motion (a1 a2 a3 eps C : R) (p b y v z : R -> R) : Prop :=
  (forall t, p t = a1 * t) /\
  (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) /\
  is_lim (fun x => (b (- x) - a2 / (a1 - a3) * a1 * - x) / Rpower (x / eps) (a3 / a1)) p_infty C.

(** For each C there is exactly one. *)
Definition slow_motion_exists : Prop := forall a1 a2 a3 eps C, parameters a1 a3 eps ->
  exists p b y v z, slow_motion a1 a2 a3 eps C p b y v z.

Definition slow_motion_unique : Prop := forall a1 a2 a3 eps C p b y v z p' b' y' v' z', parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> slow_motion a1 a2 a3 eps C p' b' y' v' z' ->
  forall t, p t = p' t /\ b t = b' t /\ y t = y' t /\ v t = v' t /\ z t = z' t.

(** Growth below that of the fast modes, for instance polynomial growth. *)
Definition slow_at_left (eps : R) (f : R -> R) : Prop :=
  exists A T, forall t, t <= T -> Rabs (f t) <= A * exp (- t / (16 * eps)).

(** They are the motions in contact whose b does not grow exponentially at t -> -oo. *)
Definition slow_motions_are_all : Prop := forall a1 a2 a3 eps p b y v z, parameters a1 a3 eps ->
  (forall t, p t = a1 * t) -> (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) ->
  (slow_at_left eps b <-> exists C, slow_motion a1 a2 a3 eps C p b y v z).

(** modelSysDev for the deviation of b from its trivial part, and modelSysDevRecoverY, V, Z, LN for the other
    deviations. *)
Definition deviation_form (a1 a2 a3 eps : R) (b y v z : R -> R) : Prop :=
  let h t := b t - a2 / (a1 - a3) * a1 * t in
  (forall k t, (k <= 4)%nat -> ex_derive_n h k t) /\
  forall t,
    a3 * h t - a1 * t * Derive h t + eps * ((a3 - a1) * Derive h t - a1 * t * Derive_n h 2 t)
      - 2 * eps ^ 2 * Derive_n h 3 t - eps ^ 3 * Derive_n h 4 t = 0 /\
    a3 * (y t - 2 * (eps ^ 2 * a2 / (a1 - a3)))
      = eps ^ 2 * (a3 * h t - a1 * t * Derive h t + 2 * Derive h t) - eps ^ 3 * Derive_n h 2 t
        - eps ^ 4 * Derive_n h 3 t /\
    a3 * v t = - eps * (a3 * h t - a1 * t * Derive h t) + 2 * eps ^ 2 * Derive_n h 2 t + eps ^ 3 * Derive_n h 3 t /\
    a3 * (z t - eps ^ 2 * a2 / (a1 - a3))
      = eps ^ 2 * (a3 * h t - a1 * t * Derive h t + Derive h t) - eps ^ 3 * Derive_n h 2 t - eps ^ 4 * Derive_n h 3 t /\
    a3 * (linear_force eps (y t) (z t) - a2 / (a3 - a1)) = - Derive h t.

(** With p = a1 t they say the same as the equations in contact. *)
Definition deviation_recover : Prop := forall a1 a2 a3 eps p b y v z, a3 <> 0 -> a1 <> a3 -> 0 < eps ->
  (forall t, p t = a1 * t) ->
  ((forall t, model_at a1 a2 a3 eps linear_force p b y v z t) <-> deviation_form a1 a2 a3 eps b y v z).

(** The side rule at every eps, for every non-integer beta: on the slow manifold the force tends to +oo or to -oo
    with the sign of C Gamma(-beta). *)
Definition side_rule : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z ->
  (0 < C * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t -> M <= linear_force eps (y t) (z t)) /\
  (C * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> linear_force eps (y t) (z t) <= M).

(** 0 < beta < 1 and C < 0: the force less its mean is positive, and increases from 0 to +oo. *)
Definition force_deviation : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < 1 -> C < 0 ->
  let deviation t := linear_force eps (y t) (z t) - a2 / (a3 - a1) in
  (forall t, 0 < deviation t) /\ (forall s t, s < t -> deviation s < deviation t) /\
  (forall d, 0 < d -> exists T, forall t, t <= T -> deviation t < d) /\
  (forall M, exists T, forall t, T <= t -> M <= deviation t).

(** Impact without collision: the side of C for which the force increases; 0 < beta < 2. *)
Definition IWC_side (beta C : R) : Prop := (beta < 1 /\ C < 0) \/ (1 < beta < 2 /\ 0 < C).

(** Any motion of the mechanism (with compl2) from a state of a slow motion with y <= z keeps contact for ever after;
    the force increases strictly and tends to +oo, and y to -oo. *)
Definition IWC_compliant : Prop := forall a1 a2 a3 eps C t0 P B Y V Z p b y v z, parameters a1 a3 eps ->
  IWC_side (a3 / a1) C -> slow_motion a1 a2 a3 eps C P B Y V Z ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 -> y t0 <= z t0 ->
  (forall t, t0 < t -> y t < z t) /\
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** There is such a motion of the mechanism, and from t0 on it is the slow motion itself. *)
Definition IWC_motion_exists : Prop := forall a1 a2 a3 eps C t0 P B Y V Z, parameters a1 a3 eps ->
  IWC_side (a3 / a1) C -> slow_motion a1 a2 a3 eps C P B Y V Z -> Y t0 <= Z t0 -> exists p b y v z,
  (forall t, model_at a1 a2 a3 eps contact_force p b y v z t) /\
  forall t, t0 <= t -> p t = P t /\ b t = B t /\ y t = Y t /\ v t = V t /\ z t = Z t.

(** On the other side the force of a slow motion decreases strictly and vanishes exactly once: lift-off. *)
Definition lift_off_compliant : Prop := forall a1 a2 a3 eps C t0 p b y v z, parameters a1 a3 eps ->
  IWC_side (a3 / a1) (- C) -> slow_motion a1 a2 a3 eps C p b y v z -> y t0 < z t0 ->
  (forall s t, s < t -> linear_force eps (y t) (z t) < linear_force eps (y s) (z s)) /\
  exists t1, t0 < t1 /\ y t1 = z t1 /\ (forall t, t < t1 -> y t < z t) /\ (forall t, t1 < t -> z t < y t).

(** Case I (0 < beta < 1, a2 < 0), C < 0: the force of the slow motion is negative up to one instant and positive after;
    from that instant on it is a motion of the mechanism. *)
Definition case_I : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  a3 / a1 < 1 -> a2 < 0 -> C < 0 -> slow_motion a1 a2 a3 eps C p b y v z ->
  exists t0, (forall t, t < t0 -> z t < y t) /\ (forall t, t0 < t -> y t < z t) /\
    forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t.

(** Case II (0 < beta < 1, a2 > 0), any motion of the mechanism on R that is in contact for t < t1 and whose b does not
    grow exponentially at t -> -oo: the trivial one; or impact without collision; or lift-off. *)
Definition case_II : Prop := forall a1 a2 a3 eps t1 p b y v z, parameters a1 a3 eps ->
  a3 / a1 < 1 -> 0 < a2 -> (forall t, p t = a1 * t) ->
  (forall t, model_at a1 a2 a3 eps contact_force p b y v z t) -> (forall t, t < t1 -> y t < z t) ->
  slow_at_left eps b ->
  let lambda t := contact_force eps (y t) (z t) in
  let mean := a2 / (a3 - a1) in
  ((forall t, y t < z t) /\ forall t, lambda t = mean) \/
  ((forall t, y t < z t) /\ (forall t, mean < lambda t) /\ (forall s t, s < t -> lambda s < lambda t) /\
     (forall M, exists T, forall t, T <= t -> M <= lambda t) /\ (forall M, exists T, forall t, T <= t -> y t <= M)) \/
  (exists t2, (forall t, t < t2 -> y t < z t) /\ y t2 = z t2 /\ (forall t, t < t2 -> lambda t < mean) /\
     forall s t, s < t -> t <= t2 -> lambda t < lambda s).

(** The force at leading order, for b - (its trivial part) ~ C_1 (-t)^beta at t -> -oo. *)
Definition leading_force (a1 a2 a3 eps C1 : R) (theta : R -> R) (t : R) : R :=
  let beta := a3 / a1 in
  let kappa := Rpower (- a1 / 2) (1 / 3) in
  a2 / (a3 - a1)
    - C1 / a3 * Rpower kappa (1 - beta) * Rpower eps ((2 * beta - 2) / 3)
        * Derive theta (kappa * t * Rpower eps (- 2 / 3)).

(** The side rule at leading order: the force tends to +oo or to -oo with the sign of C_1 Gamma(-beta). *)
Definition leading_side_rule : Prop := forall a1 a2 a3 eps C1 theta, parameters a1 a3 eps -> is_Theta (a3 / a1) theta ->
  (0 < C1 * Gamma (- (a3 / a1)) -> forall M, exists T, forall t, T <= t ->
    M <= leading_force a1 a2 a3 eps C1 theta t) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> forall M, exists T, forall t, T <= t -> leading_force a1 a2 a3 eps C1 theta t <= M).

(** 0 < beta < 5: at every time and every eps the force of the slow motion is above the one at leading order if
    C_1 Gamma(-beta) > 0, and below it if C_1 Gamma(-beta) < 0. *)
Definition force_above_leading_order : Prop := forall a1 a2 a3 eps C1 theta p b y v z t, parameters a1 a3 eps ->
  a3 / a1 < 5 -> is_Theta (a3 / a1) theta -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
  (0 < C1 * Gamma (- (a3 / a1)) -> leading_force a1 a2 a3 eps C1 theta t < linear_force eps (y t) (z t)) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> linear_force eps (y t) (z t) < leading_force a1 a2 a3 eps C1 theta t).

(** eps_0 = ((mean force) |a3| kappa^(beta-1) / m)^(3/(2 beta - 2)), -m a lower bound of C_1 dTheta/dtau. *)
Definition threshold (a1 a2 a3 m : R) : R :=
  let beta := a3 / a1 in
  let kappa := Rpower (- a1 / 2) (1 / 3) in
  Rpower (- a3 * (a2 / (a3 - a1)) * Rpower kappa (beta - 1) / m) (3 / (2 * beta - 2)).

(** At leading order, beta > 1, a2 < 0: for every eps < eps_0 the force is positive at all times from that of tau0
    on. *)
Definition leading_force_positive : Prop := forall a1 a2 a3 eps C1 theta m tau0 t, a1 < 0 -> a3 < 0 -> 0 < eps ->
  1 < a3 / a1 -> a2 < 0 -> 0 < m -> (forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) ->
  eps < threshold a1 a2 a3 m -> tau0 <= Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) ->
  0 < leading_force a1 a2 a3 eps C1 theta t.

(** Case III (a2 < 0), 1 < beta < 5, C_1 on the side of impact without collision, eps <= eps_0: any motion of the
    mechanism (with compl2) from a state of the slow motion at a time t0 >= (that of tau0) keeps contact for ever; the
    force tends to +oo, y to -oo. *)
Definition IWC_below_threshold : Prop := forall a1 a2 a3 eps C1 theta m tau0 t0 P B Y V Z p b y v z,
  parameters a1 a3 eps ->
  1 < a3 / a1 < 5 -> a2 < 0 -> 0 < C1 * Gamma (- (a3 / a1)) -> is_Theta (a3 / a1) theta ->
  0 < m -> (forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) -> eps <= threshold a1 a2 a3 m ->
  slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) P B Y V Z ->
  tau0 <= Rpower (- a1 / 2) (1 / 3) * t0 * Rpower eps (- 2 / 3) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** Such a bound exists on every half-line [tau0, oo), and for C_1 < 0 on the whole line. *)
Definition least_value_exists : Prop := forall b theta C1, 0 < b -> not_nat b -> is_Theta b theta ->
  0 < C1 * Gamma (- b) ->
  (forall tau0, exists m, 0 < m /\ forall tau, tau0 <= tau -> - m <= C1 * Derive theta tau) /\
  (C1 < 0 -> exists m, 0 < m /\ forall tau, - m <= C1 * Derive theta tau).

(** The force less its mean, and its first three derivatives in contact, as functions of the state. *)
Definition force_excess (a1 a2 a3 eps : R) (y z : R) : R := (z - y) / eps ^ 2 - a2 / (a3 - a1).
Definition force_excess1 (eps : R) (y v z : R) : R := ((y - 2 * z) / eps - v) / eps ^ 2.
Definition force_excess2 (eps : R) (p b y v z : R) : R :=
  ((v - 2 * ((y - 2 * z) / eps)) / eps - (b + p * ((z - y) / eps ^ 2))) / eps ^ 2.
Definition force_excess3 (a1 a2 a3 eps : R) (p b y v z : R) : R :=
  ((b + p * ((z - y) / eps ^ 2) - 2 * ((v - 2 * ((y - 2 * z) / eps)) / eps)) / eps
   - (a2 - a3 * ((z - y) / eps ^ 2) + a1 * ((z - y) / eps ^ 2) + p * force_excess1 eps y v z)) / eps ^ 2.

(** beta < 1, after the G-spot: an open set of states, off the slow manifold too, from which contact is never
    lost and the force increases for ever. *)
Definition IWC_open : Prop := forall a1 a2 a3 eps t0 p b y v z, a1 < 0 -> a1 < a3 -> 0 < eps -> 0 <= t0 ->
  (forall t, t0 <= t -> p t = a1 * t) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  y t0 < z t0 -> 0 < force_excess a1 a2 a3 eps (y t0) (z t0) -> 0 < force_excess1 eps (y t0) (v t0) (z t0) ->
  0 < force_excess2 eps (p t0) (b t0) (y t0) (v t0) (z t0) ->
  0 < force_excess3 a1 a2 a3 eps (p t0) (b t0) (y t0) (v t0) (z t0) ->
  (forall t, t0 <= t -> y t < z t) /\
  forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t).

(** It is not empty: for 0 < beta < 1 it holds every slow motion with C < 0, while that is in contact. *)
Definition open_set_holds_slow_motions : Prop := forall a1 a2 a3 eps C t p b y v z, parameters a1 a3 eps ->
  a1 < a3 -> C < 0 -> slow_motion a1 a2 a3 eps C p b y v z -> y t < z t ->
  0 < force_excess a1 a2 a3 eps (y t) (z t) /\ 0 < force_excess1 eps (y t) (v t) (z t) /\
  0 < force_excess2 eps (p t) (b t) (y t) (v t) (z t) /\ 0 < force_excess3 a1 a2 a3 eps (p t) (b t) (y t) (v t) (z t).

(** Every beta but 1, p <= - (6 - 2 a3 eps): an open set of states from which contact is never lost, the force increases
    to +oo and y tends to -oo. *)
Definition late_cone (a1 a2 a3 eps p b y v z : R) : Prop :=
  let d := b - a2 / (a1 - a3) * p in
  let d0 := force_excess a1 a2 a3 eps y z in let d1 := force_excess1 eps y v z in
  let d2 := force_excess2 eps p b y v z in
  0 < d /\ d < - a3 * eps * d0 /\ d0 < eps * d1 /\ eps * d1 + 2 * d0 < eps ^ 2 * d2.

Definition IWC_late : Prop := forall a1 a2 a3 eps t0 p b y v z, a1 < 0 -> a3 < 0 -> a1 <> a3 -> 0 < eps ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 <= - (6 - 2 * a3 * eps) -> y t0 < z t0 -> late_cone a1 a2 a3 eps (p t0) (b t0) (y t0) (v t0) (z t0) ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall s t, t0 <= s -> s < t -> contact_force eps (y s) (z s) < contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** The slow motions on the side of impact without collision come into it. *)
Definition late_cone_holds_slow_motions : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  0 < C * Gamma (- (a3 / a1)) -> slow_motion a1 a2 a3 eps C p b y v z ->
  exists T, forall t, T <= t -> p t <= - (6 - 2 * a3 * eps) /\ y t < z t /\
    late_cone a1 a2 a3 eps (p t) (b t) (y t) (v t) (z t).

(** Impact without collision is stable, from before the G-spot (t0 < 0, p > 0) as from after it. If a slow motion on
    that side is in contact from t0 on, so is every motion of the mechanism whose state at t0 is near that of the slow
    motion, fast modes or not; its force tends to +oo, and y to -oo. *)
Definition IWC_stable : Prop := forall a1 a2 a3 eps C t0 P B Y V Z, parameters a1 a3 eps ->
  0 < C * Gamma (- (a3 / a1)) -> slow_motion a1 a2 a3 eps C P B Y V Z -> (forall t, t0 <= t -> Y t < Z t) ->
  exists delta, 0 < delta /\ forall p b y v z, (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** Any motion in contact, on the slow manifold or not: the number K that the quotient of its force, less the mean, by
    that of the slow motion with C = 1 tends to. *)
Definition side_number (a1 a2 a3 eps : R) (y z : R -> R) (K : R) : Prop := forall P B Y V Z,
  slow_motion a1 a2 a3 eps 1 P B Y V Z ->
  is_lim (fun t => force_excess a1 a2 a3 eps (y t) (z t) / force_excess a1 a2 a3 eps (Y t) (Z t)) p_infty K.

(** The exact side rule. There is such a number for the motion from every state ([motion_exists]); with K Gamma(-beta) >
    0 the force tends to +oo, with K Gamma(-beta) < 0 to -oo, faster than every exponential; with K = 0 it grows more
    slowly than every exponential. *)
Definition side_rule_every_state : Prop := forall a1 a2 a3 eps t0 p b y v z, parameters a1 a3 eps ->
  (forall t, t0 <= t -> p t = a1 * t /\ model_at a1 a2 a3 eps linear_force p b y v z t) ->
  let excess t := force_excess a1 a2 a3 eps (y t) (z t) in
  exists K, side_number a1 a2 a3 eps y z K /\
  (0 < K * Gamma (- (a3 / a1)) -> forall g, exists T, forall t, T <= t -> exp (g * t) <= excess t) /\
  (K * Gamma (- (a3 / a1)) < 0 -> forall g, exists T, forall t, T <= t -> excess t <= - exp (g * t)) /\
  (K = 0 -> forall g, 0 < g -> exists A T, forall t, T <= t -> Rabs (excess t) <= A * exp (g * t)).

(** On the slow manifold it is C; and it is a linear function of the state at t0, less that of the trivial motion. So K
    = 0 is a hyperplane. *)
Definition side_number_slow : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> side_number a1 a2 a3 eps y z C.

Definition side_number_linear : Prop := forall a1 a2 a3 eps t0 k k' K K' p b y v z p' b' y' v' z' p'' b'' y'' v'' z'',
  parameters a1 a3 eps ->
  (forall t, t0 <= t -> p t = a1 * t /\ model_at a1 a2 a3 eps linear_force p b y v z t) ->
  (forall t, t0 <= t -> p' t = a1 * t /\ model_at a1 a2 a3 eps linear_force p' b' y' v' z' t) ->
  (forall t, t0 <= t -> p'' t = a1 * t /\ model_at a1 a2 a3 eps linear_force p'' b'' y'' v'' z'' t) ->
  let B := a2 / (a1 - a3) * (a1 * t0) in let Z := eps ^ 2 * a2 / (a1 - a3) in let Y := 2 * Z in
  b'' t0 - B = k * (b t0 - B) + k' * (b' t0 - B) -> y'' t0 - Y = k * (y t0 - Y) + k' * (y' t0 - Y) ->
  v'' t0 = k * v t0 + k' * v' t0 -> z'' t0 - Z = k * (z t0 - Z) + k' * (z' t0 - Z) ->
  side_number a1 a2 a3 eps y z K -> side_number a1 a2 a3 eps y' z' K' ->
  side_number a1 a2 a3 eps y'' z'' (k * K + k' * K').

(** A motion of the mechanism whose contact lasts for ever has K Gamma(-beta) >= 0. *)
Definition lasting_contact : Prop := forall a1 a2 a3 eps t0 K p b y v z, parameters a1 a3 eps ->
  (forall t, t0 <= t -> p t = a1 * t /\ model_at a1 a2 a3 eps contact_force p b y v z t /\ y t < z t) ->
  side_number a1 a2 a3 eps y z K -> 0 <= K * Gamma (- (a3 / a1)).

(** [IWC_stable] for every motion, fast modes or not: a contact that lasts for ever with K Gamma(-beta) > 0 is
    stable. *)
Definition IWC_stable_every_state : Prop := forall a1 a2 a3 eps K t0 P B Y V Z, parameters a1 a3 eps ->
  (forall t, t0 <= t -> P t = a1 * t /\ model_at a1 a2 a3 eps contact_force P B Y V Z t /\ Y t < Z t) ->
  side_number a1 a2 a3 eps Y Z K -> 0 < K * Gamma (- (a3 / a1)) ->
  exists delta, 0 < delta /\ forall p b y v z, (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** Every non-integer beta < n + 2, C on the side of impact without collision: once the force of a slow motion and its
    first n derivatives are >= 0 at one time, contact is kept ever after. On either side the force vanishes at most n +
    1 times. *)
Definition contact_tail : Prop := forall a1 a2 a3 eps C n t0 p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < INR (n + 2) -> 0 < C * Gamma (- (a3 / a1)) ->
  (forall k, (k <= n)%nat -> 0 <= Derive_n (fun t => linear_force eps (y t) (z t)) k t0) ->
  forall t, t0 < t -> y t < z t.

Definition force_zeros : Prop := forall a1 a2 a3 eps C n l p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> a3 / a1 < INR (n + 2) -> C <> 0 ->
  StronglySorted Rlt l -> (forall t, In t l -> y t = z t) -> (length l <= n + 1)%nat.

(** The trivial solution as printed, modelSysDistZY with z = y/2 = - eps^2 a2/(a1 - a3), solves the contact equations at
    no time; with + in place of - it solves them (it is the slow motion with C = 0). *)
Definition printed_trivial_is_wrong : Prop := forall a1 a2 a3 eps t, 0 < eps -> a1 <> a3 -> a2 <> 0 -> a3 <> 0 ->
  ~ model_at a1 a2 a3 eps linear_force (fun t => a1 * t) (fun t => a2 / (a1 - a3) * a1 * t)
      (fun _ => 2 * (- eps ^ 2 * a2 / (a1 - a3))) (fun _ => 0) (fun _ => - eps ^ 2 * a2 / (a1 - a3)) t.

Definition corrected_trivial : Prop := forall a1 a2 a3 eps t, 0 < eps -> a1 <> a3 ->
  model_at a1 a2 a3 eps linear_force (fun t => a1 * t) (fun t => a2 / (a1 - a3) * a1 * t)
    (fun _ => 2 * (eps ^ 2 * a2 / (a1 - a3))) (fun _ => 0) (fun _ => eps ^ 2 * a2 / (a1 - a3)) t.

(** ** The deviation in the time T = t/eps, and the limit eps -> 0 *)

(** The equation modelSysDev of b in T, normalized to a1 = -1 (e is then -a1 eps), and its slow solution F. *)
Definition deviation_equation (e b : R) (f : R -> R) : Prop :=
  (forall k t, (k <= 4)%nat -> ex_derive_n f k t) /\
  forall t, - b * f t + t * Derive f t + (1 - b) * Derive f t + t * Derive_n f 2 t
    - 2 / e * Derive_n f 3 t - 1 / e * Derive_n f 4 t = 0.

Definition is_slow (e b : R) (F : R -> R) : Prop :=
  deviation_equation e b F /\ is_lim (fun x => F (- x) / Rpower x b) p_infty 1.

Definition slow_exists : Prop := forall e b, 0 < e -> not_nat b -> exists F, is_slow e b F.

Definition slow_unique : Prop := forall e b F G, 0 < e -> not_nat b -> is_slow e b F -> is_slow e b G ->
  forall t, F t = G t.

(** Gamma(-b) F^(n) = int_0^oo r^(n-b-1) e^(psi(r)/e + rT) dr, n > b, with psi = r - r^2/2 - r^3/3 - ln(1 + r). *)
Definition slow_integral : Prop := forall e b n F, 0 < e -> not_nat b -> b < INR n -> is_slow e b F -> forall t,
  is_RInt_gen (fun r => Rpower r (INR n - b - 1) * exp ((r - r ^ 2 / 2 - r ^ 3 / 3 - ln (1 + r)) / e + r * t))
    (at_right 0) (Rbar_locally p_infty) (Gamma (- b) * Derive_n F n t).

(** 0 < beta < 1, every eps: all derivatives of the slow solution are negative on the whole line. *)
Definition IWC_every_eps : Prop := forall e b F, 0 < e -> 0 < b < 1 -> is_slow e b F ->
  forall n t, (1 <= n)%nat -> Derive_n F n t < 0.

(** F has at most n real zeros if b < n. *)
Definition slow_zeros : Prop := forall e b n F l, 0 < e -> not_nat b -> b < INR n -> is_slow e b F ->
  StronglySorted Rlt l -> (forall t, In t l -> F t = 0) -> (length l <= n)%nat.

(** The theorem of Budan and Fourier for F, n < b < n + 1, s_k = Gamma(-b) F^(k)(T), as for Theta: v zeros beyond T less
    an even number, n + 1 - v up to T less an even number, with multiplicity. *)
Definition slow_tail_zeros : Prop := forall e (n : nat) b F T, 0 < e -> INR n < b < INR n + 1 -> is_slow e b F ->
  let v := variations (map (fun k => Gamma (- b) * Derive_n F k T) (seq 0 (S n)) ++ [1]) in
  (exists l j, zeros_with_multiplicity F (fun t => T < t) l /\ v = (length l + 2 * j)%nat) /\
  (exists l j, zeros_with_multiplicity F (fun t => t <= T) l /\ (n + 1 = v + length l + 2 * j)%nat).

(** eps -> 0 (e = 2 eta^3, T = t/eta): eta^(b-n) F^(n)(t/eta) -> Theta^(n)(t), with an error of known sign. *)
Definition leading_order_limit : Prop := forall b n eta theta F t w, not_nat b -> b < INR n -> 0 < eta ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  is_RInt_gen (fun r => Rpower r (INR n - b + 3) * exp (r * t - r ^ 3 / 6)) (at_right 0) (Rbar_locally p_infty) w ->
  0 <= Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta) - Derive_n theta n t) <= eta / 8 * w.

(** Every eps at once: with G(t; eta) = eta^b F(t/eta) the number Gamma(-b) G^(n)(t; eta) increases strictly with eta,
    at every t, if n > b - 4. *)
Definition monotone_in_eta : Prop := forall b n eta eta' F F' t, not_nat b -> b < INR n + 4 -> 0 < eta < eta' ->
  is_slow (2 * eta ^ 3) b F -> is_slow (2 * eta' ^ 3) b F' ->
  Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta))
    < Gamma (- b) * (Rpower eta' (b - INR n) * Derive_n F' n (t / eta')).

(** It lies above Gamma(-b) Theta^(n)(t), by at most (eta/8) Gamma(-b) G^(n+4)(t; eta). *)
Definition above_leading_order : Prop := forall b n eta theta F t, not_nat b -> b < INR n + 4 -> 0 < eta ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  let G k := Rpower eta (b - INR k) * Derive_n F k (t / eta) in
  0 < Gamma (- b) * (G n - Derive_n theta n t) <= eta / 8 * (Gamma (- b) * G (n + 4)%nat).

(** The series of the weight in eta. With (1 + eta r) dh/dr = eta r^3/2, h = 0 at r = 0, e^h is sum_k eta^k sum_(m <= k)
    c_(k,m) r^(k+3m), where (k + 3m) c_(k,m) = c_(k-1,m-1)/2 - (k - 1 + 3m) c_(k-1,m), c_(0,0) = 1, c_(k,0) = c_(0,m) =
    0 for k, m > 0. *)
Fixpoint series_coefficient (k m : nat) : R :=
  match k, m with
  | O, O => 1
  | S j, S i => (series_coefficient j i / 2 - (INR j + 3 * INR m) * series_coefficient j m) / (INR k + 3 * INR m)
  | _, _ => 0
  end.

(** They are the right ones, N >= 1: the error of the first N orders is at most eta^N sum_m |c_(N,m)| r^(N+3m) e^h. *)
Definition weight_series : Prop := forall (N : nat) eta r, (1 <= N)%nat -> 0 < eta -> 0 < r ->
  let x := eta * r in
  let weight := exp ((x - x ^ 2 / 2 - x ^ 3 / 3 - ln (1 + x)) / (2 * eta ^ 3) + r ^ 3 / 3) in
  let order k := eta ^ k * sum_first (fun m => series_coefficient k m * r ^ (k + 3 * m)) (S k) in
  Rabs (weight - sum_first order N)
    <= eta ^ N * sum_first (fun m => Rabs (series_coefficient N m) * r ^ (N + 3 * m)) (S N) * weight.

(** Theorem B, N >= 1 and n > b - N - 3: G^(n) is its first N orders in eta, on the derivatives of Theta, up to
    (eta^N/|Gamma(-b)|) sum_m |c_(N,m)| Gamma(-b) G^(n+N+3m), where Gamma(-b) G^(n+N+3m) > 0. *)
Definition series_in_eta : Prop := forall b (n N : nat) eta theta F t, not_nat b -> (1 <= N)%nat ->
  b < INR n + INR N + 3 -> 0 < eta ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  let G k := Rpower eta (b - INR k) * Derive_n F k (t / eta) in
  let order k := eta ^ k * sum_first (fun m => series_coefficient k m * Derive_n theta (n + k + 3 * m) t) (S k) in
  Rabs (Gamma (- b) * (G n - sum_first order N))
    <= eta ^ N * sum_first (fun m => Rabs (series_coefficient N m) * (Gamma (- b) * G (n + N + 3 * m)%nat)) (S N).

(** Theorem C with any polynomial part: for m = 1, ..., M let K_m - m be odd. What is left of Gamma(-b) G^(n) beyond
    Theta^(n) and the terms c_(k,m) eta^k Theta^(n+k+3m), k <= K_m, is positive and increases strictly with eta, at
    every t, if n > b - 4 (M + 1) and n > b - (K_m + 1 + 3m). *)
Definition monotone_beyond_polynomial : Prop := forall b n M (K : nat -> nat) eta eta' theta F F' t, not_nat b ->
  0 < eta < eta' ->
  b < INR n + 4 * (INR M + 1) ->
  (forall m, (1 <= m <= M)%nat -> Nat.Odd (K m - m) /\ b < INR n + INR (K m) + 1 + 3 * INR m) ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F -> is_slow (2 * eta' ^ 3) b F' ->
  let part eta m := sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta (n + k + 3 * m) t)
    (S (K m)) in
  let excess eta F := Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta) - Derive_n theta n t
    - sum_first (fun i => part eta (S i)) M) in
  0 < excess eta F < excess eta' F'.

(** Its simplest case beyond P = 0, M = 1 and K_1 = 2: P has two terms, n > b - 6. *)
Definition monotone_next_order : Prop := forall b n eta eta' theta F F' t, not_nat b -> b < INR n + 6 ->
  0 < eta < eta' ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F -> is_slow (2 * eta' ^ 3) b F' ->
  let excess eta F := Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta) - Derive_n theta n t
    - eta / 8 * Derive_n theta (n + 4) t + eta ^ 2 / 10 * Derive_n theta (n + 5) t) in
  0 < excess eta F < excess eta' F'.

(** Theta with these terms, and the force at leading order with it in place of Theta, at the scale eta = (- a1
    eps/2)^(1/3). *)
Definition corrected_theta (eta : R) (M : nat) (K : nat -> nat) (theta : R -> R) (tau : R) : R :=
  theta tau + sum_first (fun i => let m := S i in
    sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta (k + 3 * m) tau) (S (K m))) M.

Definition corrected_force (a1 a2 a3 eps C1 : R) (M : nat) (K : nat -> nat) (theta : R -> R) : R -> R :=
  leading_force a1 a2 a3 eps C1 (corrected_theta (Rpower (- a1 / 2) (1 / 3) * Rpower eps (1 / 3)) M K theta).

(** M and K hold enough terms for the derivative of order n of the force at this beta. *)
Definition enough_terms (beta : R) (n M : nat) (K : nat -> nat) : Prop := beta < INR n + 4 * (INR M + 1) + 1 /\
  forall m, (1 <= m <= M)%nat -> Nat.Odd (K m - m) /\ beta < INR n + INR (K m) + 2 + 3 * INR m.

(** At every time and every eps the force of the slow motion, with its derivatives, is above the corrected one if C_1
    Gamma(-beta) > 0, and below it if C_1 Gamma(-beta) < 0. (M = 0, n = 0: [force_above_leading_order]; beta < 9: M = 1,
    K_1 = 4.) *)
Definition force_above_corrected_force : Prop := forall a1 a2 a3 eps C1 M K theta p b y v z n t, parameters a1 a3 eps ->
  enough_terms (a3 / a1) n M K -> is_Theta (a3 / a1) theta ->
  slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
  let force t := linear_force eps (y t) (z t) in
  let corrected := corrected_force a1 a2 a3 eps C1 M K theta in
  (0 < C1 * Gamma (- (a3 / a1)) -> Derive_n corrected n t < Derive_n force n t) /\
  (C1 * Gamma (- (a3 / a1)) < 0 -> Derive_n force n t < Derive_n corrected n t).

(** Every non-integer beta < n + 2 and every eps, C_1 on the side of impact without collision: if the corrected force is
    >= 0 on [t0, t1], and its first n derivatives are at t1, any motion of the mechanism from a state of the slow motion
    at t0 keeps contact for ever; the force tends to +oo, y to -oo. *)
Definition IWC_by_corrected_force : Prop := forall a1 a2 a3 eps C1 M K theta n t0 t1 P B Y V Z p b y v z,
  parameters a1 a3 eps ->
  a3 / a1 < INR n + 2 -> enough_terms (a3 / a1) 0 M K -> 0 < C1 * Gamma (- (a3 / a1)) -> is_Theta (a3 / a1) theta ->
  slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) P B Y V Z -> t0 <= t1 ->
  let corrected := corrected_force a1 a2 a3 eps C1 M K theta in
  (forall t, t0 <= t <= t1 -> 0 <= corrected t) -> (forall k, (k <= n)%nat -> 0 <= Derive_n corrected k t1) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).

(** ** Theorem D: the number of zeros at every eps > 0 (proofs/finite_epsilon_zeros.md, section 4) *)

(** l is the list of all real zeros of f, in increasing order, and all are simple. *)
Definition simple_zeros (f : R -> R) (l : list R) : Prop := zeros_of f l /\ forall t, In t l -> Derive f t <> 0.

(** Left of 0 and for b < 3, Gamma(-b) F lies below Gamma(-b) times its leading term. *)
Definition slow_below_power : Prop := forall e b F x, 0 < e -> not_nat b -> b < 3 -> is_slow e b F -> 0 < x ->
  Gamma (- b) * F (- x) < Gamma (- b) * Rpower x b.

(** For 0 < b < 3, at every e, F has one zero, two zeros, one zero, all simple: positive; on both sides of 0;
    positive. *)
Definition slow_law : Prop := forall e b F, 0 < e -> is_slow e b F ->
  (0 < b < 1 -> exists t, 0 < t /\ simple_zeros F [t]) /\
  (1 < b < 2 -> exists s t, s < 0 < t /\ simple_zeros F [s; t]) /\
  (2 < b < 3 -> exists t, 0 < t /\ simple_zeros F [t]).

(** The same of the mechanism, 1 < beta < 4: on a slow motion with C <> 0, how often the force is equal to its mean. *)
Definition force_law : Prop := forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps ->
  slow_motion a1 a2 a3 eps C p b y v z -> C <> 0 ->
  let deviation t := linear_force eps (y t) (z t) - a2 / (a3 - a1) in
  (1 < a3 / a1 < 2 -> exists t, 0 < t /\ simple_zeros deviation [t]) /\
  (2 < a3 / a1 < 3 -> exists s t, s < 0 < t /\ simple_zeros deviation [s; t]) /\
  (3 < a3 / a1 < 4 -> exists t, 0 < t /\ simple_zeros deviation [t]).

(** 3 < b < 4: F decreases up to a point m > 0 and increases from there, from +oo to +oo. By the sign of F m it has two
    simple zeros, one of multiplicity two, or none. *)
Definition slow_valley : Prop := forall e b F, 0 < e -> 3 < b < 4 -> is_slow e b F ->
  exists m, 0 < m /\ (forall s t, s < t -> t <= m -> F t < F s) /\ (forall s t, m <= s -> s < t -> F s < F t) /\
    is_lim F m_infty p_infty /\ is_lim F p_infty p_infty /\
    (F m < 0 -> exists s t, s < m < t /\ simple_zeros F [s; t]) /\
    (F m = 0 -> zeros_of F [m] /\ Derive_n F 2 m <> 0) /\ (0 < F m -> forall t, 0 < F t).

(** There is an e_c in (0, oo]: two zeros, both simple, for e < e_c; one, of multiplicity two, at e_c; none for e >
    e_c. *)
Definition critical_eps : Prop := forall b, 3 < b < 4 -> exists ec : Rbar, Rbar_lt 0 ec /\
  forall e F, 0 < e -> is_slow e b F ->
    (Rbar_lt e ec -> exists s t, s < t /\ simple_zeros F [s; t]) /\
    (Finite e = ec -> exists t, zeros_of F [t] /\ Derive F t = 0 /\ Derive_n F 2 t <> 0) /\
    (Rbar_lt ec e -> forall t, 0 < F t).

(** The same of the mechanism, 4 < beta < 5: the force of a slow motion with C <> 0 is equal to its mean at two times if
    -a1 eps < e_c, at one time if -a1 eps = e_c, and never if -a1 eps > e_c; e_c depends on beta alone. *)
Definition force_critical_eps : Prop := forall beta, 4 < beta < 5 -> exists ec : Rbar, Rbar_lt 0 ec /\
  forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps -> a3 / a1 = beta -> slow_motion a1 a2 a3 eps C p b y v z ->
    C <> 0 ->
    let deviation t := linear_force eps (y t) (z t) - a2 / (a3 - a1) in
    (Rbar_lt (- a1 * eps) ec -> exists s t, s < t /\ simple_zeros deviation [s; t]) /\
    (Finite (- a1 * eps) = ec -> exists t, zeros_of deviation [t]) /\
    (Rbar_lt ec (- a1 * eps) -> forall t, deviation t <> 0).

(** A bound by Theta alone, for every eta up to eta0: Gamma(-b) G(t; eta), b < 4. *)
Definition slow_upper_bound : Prop := forall b eta eta0 mu theta F t, not_nat b -> b < 4 -> 0 < eta <= eta0 -> 0 < mu ->
  2 * mu ^ 3 <= 1 ->
  is_Theta b theta -> is_slow (2 * eta ^ 3) b F ->
  Gamma (- b) * (Rpower eta b * F (t / eta))
    <= Gamma (- b) * (theta t
      + 3 * eta0 / (8 * (1 - mu ^ 3)) * (Rpower mu (b - 1) * Derive theta (t / mu) - Derive theta t)).
