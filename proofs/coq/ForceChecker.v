(** * A checker of certificates about the contact force: the decision

    [force_accepts plans c] is true only if every statement that a certificate of version 2 or 3 makes is proved. The
    pieces of version 1 are checked by [pieces_hold]; here are the size of F on a box ([stays_within]) and at a point
    ([goes_beyond]), in units of x^b at the one b = h/n of the column, the comparison of the deviation with the mean
    force, and the dip. [ForceSound.v] and [DipSound.v] prove that what is accepted is true. *)

From Coq Require Import ZArith QArith Qabs Qround Qreduction List Bool.
From GSpot Require Import CertificateText ForceText Checker CheckerCertificate.
Import ListNotations.
Open Scope Z_scope.

(** ** The size of F (proofs/check.md, section 5a) *)

(** (v x^b/one)^n against level^n for b = h/n >= 0, without denominators. *)
Definition size_of (x : Z) (b level : Q) (v : Z) : Z := (v * Zpos (Qden level)) ^ Zpos (Qden b) * x ^ Qnum b.
Definition size_allowed (one : Z) (b level : Q) : Z := (Qnum level * one) ^ Zpos (Qden b).

(** A bound of |f| on [t - s, t + s] and a lower bound of f or -f at the point of a model. *)
Definition largest_on (g : setting) (t s : Q) (l : list model) : option Z :=
  if tail_is_small (b_most g) t s (length l) then Some (fold_right (fun a s => model_norm a + s) 0 l + tail_bound l)
  else None.

Definition lower_end (s : bool) (m : model) : Z :=
  match parts m with
  | (z :: a) :: p => (if s then z else - z) - (poly_norm a + parts_norm p + error m)
  | _ => -1
  end.

(** |f| <= bound on [t1, t2], which is cut where needed. *)
Fixpoint stays_within (cuts : nat) (g : setting) (w : effort) (bound : Z -> bool) (t1 t2 : Q) (st : state)
  : option state :=
  let middle := Qred ((t1 + t2) / 2) in
  let half := Qred ((t2 - t1) / 2) in
  let direct :=
    if is_positive half then
      match advance (most_steps w) g w middle st with
      | None => None
      | Some st' =>
          match expand g w st' half with
          | None => None
          | Some l =>
              match largest_on g middle half l with
              | Some most => if bound most then Some st' else None
              | None => None
              end
          end
      end
    else None in
  match direct with
  | Some st' => Some st'
  | None =>
      match cuts with
      | O => None
      | S cuts =>
          match stays_within cuts g w bound t1 middle st with
          | Some st' => stays_within cuts g w bound middle t2 st'
          | None => None
          end
      end
  end.

(** From -x, in units of 1/one, at b in [low, high]. *)
Definition begins (p : plan) (low high : Q) : bool :=
  setting_is_right (setting_for p low high) low high && (0 <? plan_x p) && (0 <? plan_one p) &&
  less high (inject_Z (3 * Z.of_nat (plan_terms p))).
Definition first_state (p : plan) (low high : Q) : state :=
  start (plan_terms p) (setting_for p low high) (plan_x p) (plan_one p).

(** The pieces [Level] from left to right. *)
Fixpoint levels_walk (g : setting) (w : effort) (bound : Z -> bool) (parts : list part) (st : state) : bool :=
  match parts with
  | [] => true
  | Level t1 t2 :: rest =>
      match stays_within (halvings w) g w bound t1 t2 st with
      | Some st' => levels_walk g w bound rest st'
      | None => false
      end
  | _ :: rest => levels_walk g w bound rest st
  end.

Definition levels_hold (p : plan) (b level : Q) (parts : list part) : bool :=
  let allowed := size_allowed (plan_one p) b level in
  if begins p b b then
    levels_walk (setting_for p b b) (plan_effort p) (fun v => size_of (plan_x p) b level v <=? allowed) parts
      (first_state p b b)
  else false.

Definition goes_beyond (p : plan) (s : bool) (b level tau : Q) : bool :=
  if begins p b b then
    match advance (most_steps (plan_effort p)) (setting_for p b b) (plan_effort p) tau (first_state p b b) with
    | Some st =>
        let v := lower_end s (value0 st) in
        (0 <=? v) && (size_allowed (plan_one p) b level <=? size_of (plan_x p) b level v)
    | None => false
    end
  else false.

(** ** The numbers of the system *)

(** (|C_1/alpha_3| beta level/mean)^(3n) (2 eps^2/(-alpha_1))^h against 1, beta - 1 = h/n: both sides. *)
Definition deviation (a1 a2 a3 c1 eps level : Q) : Z * Z :=
  let beta := Qred (a3 / a1) in
  let h := Qnum beta - Zpos (Qden beta) in
  let n := Zpos (Qden beta) in
  let one := Qred (Qabs (c1 / a3) * beta * level / (a2 / (a3 - a1))) in
  let two := Qred (2 * (eps * eps) / - a1) in
  (Qnum one ^ (3 * n) * Qnum two ^ h, Zpos (Qden one) ^ (3 * n) * Zpos (Qden two) ^ h).

(** beta is in (1, 5) and in the cell (m, m + 1). *)
Definition system_holds (a1 a2 a3 eps level : Q) (m : nat) : bool :=
  let beta := Qred (a3 / a1) in
  less a1 0 && less a2 0 && less a3 0 && less 0 eps && less 0 level && less 1 beta && less beta 5 &&
  less (inject_Z (Z.of_nat m)) beta && less beta (inject_Z (Z.of_nat m) + 1).

(** C_1 Gamma(-beta) > 0, or < 0: Gamma(-beta) has the sign (-1)^(m + 1). *)
Definition side_is (positive : bool) (m : nat) (c1 : Q) : bool :=
  if Bool.eqb positive (Nat.even m) then less c1 0 else less 0 c1.

(** ** Columns *)
Definition known_of (parts : list part) : list entry :=
  flat_map (fun p => match p with Known p => [p] | _ => [] end) parts.

Definition part_ends (p : part) : edge * edge :=
  match p with Known p => ends_of p | Level t1 t2 | Dip t1 t2 => (At t1, At t2) end.

(** A piece gives F the sign (-1)^m, or bounds |F|. *)
Definition part_serves (m : nat) (p : part) : bool :=
  match p with
  | Known (Left _) => Nat.even m
  | Known (Sign _ _ s) => Bool.eqb s (Nat.even m)
  | Known (Right _ v) => Nat.eqb v 0
  | Level _ _ => true
  | _ => false
  end.

(** The one column of a claim about beta. *)
Definition one_strip (beta : Q) (l : list strip) : option strip :=
  match l with
  | [c] => if Qeq_bool (strip_from c) beta && Qeq_bool (strip_to c) beta then Some c else None
  | _ => None
  end.

Definition force_holds (p : plan) (a1 a2 a3 c1 eps level : Q) (tau : interval) (c : strip) : bool :=
  let beta := Qred (a3 / a1) in
  let known := Block (At beta) beta (known_of (strip_parts c)) in
  let m := cell_of known in
  let (above, below) := deviation a1 a2 a3 c1 eps level in
  if system_holds a1 a2 a3 eps level m && side_is true m c1 && (above <=? below) &&
    covers (map part_ends (strip_parts c)) (interval_from tau) (interval_to tau) &&
    forallb (part_serves m) (strip_parts c)
  then if pieces_hold p known then levels_hold p (beta - 1) level (strip_parts c) else false
  else false.

Definition lift_off_holds (p : plan) (a1 a2 a3 c1 eps level tau : Q) (c : strip) : bool :=
  let beta := Qred (a3 / a1) in
  let m := cell_of (Block (At beta) beta []) in
  let (above, below) := deviation a1 a2 a3 c1 eps level in
  if system_holds a1 a2 a3 eps level m && side_is false m c1 && (below <=? above) &&
    match strip_parts c with [Level t1 t2] => Qle_bool t1 tau && Qle_bool tau t2 | _ => false end
  then goes_beyond p (Nat.even m) (beta - 1) level tau
  else false.

(** ** A dip (proofs/check.md, section 5b) *)

(** How to compute on a column; for a dip, two numbers between which (t1/t2)^(b - 1) lies there, each with an exponent
    beyond the end of the column that it belongs to: of a smaller denominator, so that the powers are short. *)
Record force_plan := ForcePlan { walk_plan : plan; power_below : Q; longest_exponent : Q; power_above : Q;
  shortest_exponent : Q }.

(** r <= mu^c, or mu^c <= r, for c = h/n >= 0 and mu, r > 0. *)
Definition below_power (r mu c : Q) : bool :=
  less 0 r && (0 <=? Qnum c) &&
  (Qnum r ^ Zpos (Qden c) * Zpos (Qden mu) ^ Qnum c <=? Zpos (Qden r) ^ Zpos (Qden c) * Qnum mu ^ Qnum c).
Definition above_power (r mu c : Q) : bool :=
  less 0 r && (0 <=? Qnum c) &&
  (Zpos (Qden r) ^ Zpos (Qden c) * Qnum mu ^ Qnum c <=? Qnum r ^ Zpos (Qden c) * Zpos (Qden mu) ^ Qnum c).

(** f(t1) + weight (power f'(t2) - f'(t1)) < 0 for each power between the two of the plan: with the lower one, up to
    what another one changes. *)
Definition dips_at (p : force_plan) (weight t1 t2 low high : Q) : bool :=
  let w := walk_plan p in
  let g := setting_for w low high in
  let e := plan_effort w in
  if begins w low high then
    match advance (most_steps e) g e t1 (first_state w low high) with
    | None => false
    | Some st1 =>
        match advance (most_steps e) g e t2 st1 with
        | None => false
        | Some st2 =>
            let one := Qred (- (weight / scale st1)) in
            let two := Qred (weight / scale st2 * power_below p) in
            let other := Qred (weight / scale st2 * (power_above p - power_below p)) in
            let sum := model_plus (model_plus (value0 st1) (multiple g one (value1 st1)))
              (multiple g two (value1 st2)) in
            match sign_of (Qceiling (other * inject_Z (model_norm (value1 st2)))) sum with
            | Some false => true
            | _ => false
            end
        end
    end
  else false.

(** J, halved at most n times where that is needed. *)
Fixpoint dips (n : nat) (p : force_plan) (weight t1 t2 low high : Q) : bool :=
  if dips_at p weight t1 t2 low high then true
  else
    match n with
    | O => false
    | S n =>
        let middle := Qred ((low + high) / 2) in
        if dips n p weight t1 t2 low middle then dips n p weight t1 t2 middle high else false
    end.

Definition dip_holds (p : force_plan) (eta : Q) (c : strip) : bool :=
  match strip_parts c with
  | [Dip t1 t2] =>
      let mu := Qred (t1 / t2) in
      let low := Qred (strip_from c - 1) in
      let high := Qred (strip_to c - 1) in
      if less 0 t1 && less t1 t2 && Qle_bool (2 * (t1 * t1 * t1)) (t2 * t2 * t2) &&
        Qle_bool high (longest_exponent p + 1) && Qle_bool (shortest_exponent p + 1) low &&
        below_power (power_below p) mu (longest_exponent p) && above_power (power_above p) mu (shortest_exponent p)
      then dips (plan_halvings (walk_plan p)) p (Qred (3 * eta / (8 * (1 - mu * mu * mu)))) t1 t2 low high
      else false
  | _ => false
  end.

(** ** Statements *)
Fixpoint each_strip (eta : Q) (plans : list force_plan) (l : list strip) : bool :=
  match plans, l with
  | [], [] => true
  | p :: plans, c :: l => if dip_holds p eta c then each_strip eta plans l else false
  | _, _ => false
  end.

Definition force_accepts (plans : list force_plan) (c : force_data) : bool :=
  match force_claimed c with
  | ForceClaim a1 a2 a3 c1 eps level tau =>
      match plans, one_strip (Qred (a3 / a1)) (strips c) with
      | [p], Some c => force_holds (walk_plan p) a1 a2 a3 c1 eps level tau c
      | _, _ => false
      end
  | LiftOffClaim a1 a2 a3 c1 eps level tau =>
      match plans, one_strip (Qred (a3 / a1)) (strips c) with
      | [p], Some c => lift_off_holds (walk_plan p) a1 a2 a3 c1 eps level tau c
      | _, _ => false
      end
  | SlowZerosClaim beta eps eta =>
      if edge_le (At 4) (interval_from beta) && edge_le (interval_to beta) (At 5) && less 0 eta &&
        Qle_bool eps (2 * (eta * eta * eta)) &&
        covers (map (fun c => (At (strip_from c), At (strip_to c))) (strips c)) (interval_from beta) (interval_to beta)
      then each_strip eta plans (strips c) else false
  end.
