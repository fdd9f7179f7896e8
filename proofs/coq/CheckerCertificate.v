(** * A checker of certificates: the decision

    [accepts plans c] is true only if every statement that a certificate makes is proved: the covers, the comparisons of
    the pieces, and their signs, which [Checker.v] finds. The plans say how exactly and in how many parts to compute;
    nothing depends on them but whether the answer is found. *)

From Coq Require Import Reals ZArith QArith Qabs Qround Qreduction Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCertificate CertificateText Checker.
Import ListNotations.
Open Scope Z_scope.

(** ** Numbers and ranges *)

Definition less (p q : Q) : bool := negb (Qle_bool q p).

Definition edge_le (e e' : edge) : bool :=
  match e, e' with
  | MinusInfinity, _ | _, PlusInfinity => true
  | At p, At q => Qle_bool p q
  | _, _ => false
  end.

Definition edge_lt (e e' : edge) : bool :=
  match e, e' with
  | MinusInfinity, MinusInfinity => false
  | MinusInfinity, _ => true
  | At p, At q => less p q
  | At _, PlusInfinity => true
  | _, _ => false
  end.

Definition edge_same (e e' : edge) : bool := edge_le e e' && edge_le e' e.

Fixpoint covers (parts : list (edge * edge)) (start stop : edge) : bool :=
  match parts with
  | [] => false
  | (low, high) :: rest => edge_le low start &&
      match rest with
      | [] => edge_le stop high
      | (next, _) :: _ => edge_same next high && covers rest high stop
      end
  end.

Definition interval_holds (r : interval) (q : Q) : bool :=
  (if has_from r then edge_le (interval_from r) (At q) else edge_lt (interval_from r) (At q)) &&
  (if has_to r then edge_le (At q) (interval_to r) else edge_lt (At q) (interval_to r)).

(** All numbers of the range are > 0, or all are < 0. *)
Definition all_positive (r : interval) : bool :=
  match interval_from r with At q => if has_from r then less 0 q else Qle_bool 0 q | _ => false end.
Definition all_negative (r : interval) : bool :=
  match interval_to r with At q => if has_to r then less q 0 else Qle_bool q 0 | _ => false end.

(** ** Columns and pieces *)

Definition ends_of (p : entry) : edge * edge :=
  match p with
  | Laplace => (MinusInfinity, PlusInfinity)
  | Taylor => (At 0, PlusInfinity)
  | Left X => (MinusInfinity, At X)
  | Right T _ => (At T, PlusInfinity)
  | Sign t1 t2 _ | Monotone t1 t2 _ | Fold t1 t2 | Hinge t1 t2 => (At t1, At t2)
  end.

(** beta in [m, m + 1], or beta <= 1. *)
Definition cell_of (c : block) : nat := Z.to_nat (Qceiling (beta_to c) - 1).

Definition block_in_cell (c : block) : bool :=
  let m := inject_Z (Z.of_nat (cell_of c)) in
  Qle_bool (beta_to c) (m + 1) && (Nat.eqb (cell_of c) 0 || edge_le (At m) (beta_from c)).

Definition larger (p q : Q) : Q := if Qle_bool p q then q else p.

(** The product of max(|b_low - i|, |b_high - i|), i < n. *)
Fixpoint factors (low high : Q) (n : nat) : Q :=
  match n with
  | O => 1
  | S n => Qred (factors low high n * larger (Qabs (low - 1 - inject_Z (Z.of_nat n)))
    (Qabs (high - 1 - inject_Z (Z.of_nat n))))
  end.

Fixpoint natural_power (q : Q) (n : nat) : Q := match n with O => 1 | S n => Qred (q * natural_power q n) end.

Definition far_left (c : block) (X : Q) : bool :=
  let N := S ((cell_of c - 1) / 3) in
  match beta_from c with
  | At low =>
      less X 0 && Qle_bool 0 low &&
      less (factors low (beta_to c) (3 * N)) (natural_power (- X) (3 * N) * natural_power 3 N * inject_Z
        (Z.of_nat (fact N)))
  | _ => false
  end.

(** What is checked without computing F. *)
Definition entry_fits (c : block) (p : entry) : bool :=
  edge_lt (fst (ends_of p)) (snd (ends_of p)) &&
  match p with
  | Laplace | Taylor => Qle_bool (beta_to c) 1
  | Left X => far_left c X
  | Sign _ _ _ | Monotone _ _ _ => true
  | Fold _ _ => false
  | Hinge t1 t2 => Nat.leb 1 (cell_of c) && (Qeq_bool t1 0 || Qeq_bool t2 0)
  | Right T v => Nat.leb 1 (cell_of c) && Nat.leb v 1
  end.

(** ** The signs of F, for a part of J *)

(** How to compute: from -x, with so many terms, in units of 1/one; how often J may be halved. *)
Record plan := Plan { plan_x : Z; plan_terms : nat; plan_one : Z; plan_halvings : nat; plan_degrees : list nat;
  plan_effort : effort }.

Definition setting_for (p : plan) (low high : Q) : setting :=
  let middle := Qred ((low + high) / 2) in
  let half := Qred ((high - low) / 2) in
  let unit := Z.lcm (Zpos (Qden middle)) (Zpos (Qden half)) in
  Setting unit (Qnum middle * (unit / Zpos (Qden middle))) (Qnum half * (unit / Zpos (Qden half)))
    (Z.max (Qceiling (Qabs low)) (Qceiling (Qabs high)) + 2) (plan_degrees p).

Definition setting_is_right (g : setting) (low high : Q) : bool :=
  (0 <? b_unit g) && Qle_bool low high &&
  Qeq_bool (inject_Z (b_centre g - b_radius g)) (inject_Z (b_unit g) * low) &&
  Qeq_bool (inject_Z (b_centre g + b_radius g)) (inject_Z (b_unit g) * high) &&
  Qle_bool (Qabs low + 2) (inject_Z (b_most g)) && Qle_bool (Qabs high + 2) (inject_Z (b_most g)).

(** The signs of F, F', ..., F^(n-1) at T. *)
Definition signs_at (g : setting) (w : effort) (T : Q) (n : nat) (st : state) : option (list (option bool)) :=
  if is_positive (step_length w) then
    match advance (most_steps w) g w T st with
    | None => None
    | Some st' =>
        match expand g w st' (step_length w) with
        | None => None
        | Some l => Some (map (sign_of 0) (firstn n l))
        end
    end
  else None.

(** The pieces from left to right; the signs at the last one, if that is [right]. *)
Fixpoint walk (g : setting) (w : effort) (m : nat) (pieces : list entry) (st : state) : option (list (option bool)) :=
  match pieces with
  | [] => Some []
  | p :: rest =>
      match p with
      | Laplace | Taylor | Left _ => walk g w m rest st
      | Sign t1 t2 s =>
          match has_sign (halvings w) g w 0 s t1 t2 st with Some st' => walk g w m rest st' | None => None end
      | Monotone t1 t2 d =>
          match has_sign (halvings w) g w 1 d t1 t2 st with Some st' => walk g w m rest st' | None => None end
      | Hinge t1 t2 =>
          let s := negb (Nat.eqb (m mod 3) 2) in
          match has_sign (halvings w) g w 1 (if Qle_bool 0 t1 then s else negb s) t1 t2 st with
          | Some st' => walk g w m rest st'
          | None => None
          end
      | Right T _ => match rest with [] => signs_at g w T m st | _ => None end
      | Fold _ _ => None
      end
  end.

Definition walk_part (p : plan) (m : nat) (pieces : list entry) (low high : Q) : option (list (option bool)) :=
  let g := setting_for p low high in
  if setting_is_right g low high && (0 <? plan_x p) && (0 <? plan_one p) && less high
    (inject_Z (3 * Z.of_nat (plan_terms p)))
  then walk g (plan_effort p) m pieces (start (plan_terms p) g (plan_x p) (plan_one p))
  else None.

(** A sign is known on J if it is known, and the same, on both parts of J. *)
Fixpoint common_signs (one two : list (option bool)) : list (option bool) :=
  match one, two with
  | Some s :: one, Some s' :: two => (if Bool.eqb s s' then Some s else None) :: common_signs one two
  | _ :: one, _ :: two => None :: common_signs one two
  | _, _ => []
  end.

(** [right] with v changes of sign. *)
Definition right_fits (m : nat) (signs : list (option bool)) (p : entry) : bool :=
  match p with
  | Right _ v =>
      match signs with
      | Some s :: signs =>
          Nat.eqb (length signs) (m - 1) &&
          match changes s (signs ++ [Some (Nat.even m)]) with Some v' => Nat.eqb v v' | None => false end
      | _ => false
      end
  | _ => true
  end.

(** J, halved at most n times where that is needed. *)
Fixpoint walk_parts (n : nat) (p : plan) (m : nat) (pieces : list entry) (low high : Q) : option (list (option bool)) :=
  let halves :=
    match n with
    | O => None
    | S n =>
        let middle := Qred ((low + high) / 2) in
        match walk_parts n p m pieces low middle with
        | None => None
        | Some one =>
            match walk_parts n p m pieces middle high with
            | Some two => Some (common_signs one two)
            | None => None
            end
        end
    end in
  match walk_part p m pieces low high with
  | Some signs => if forallb (right_fits m signs) pieces then Some signs else halves
  | None => halves
  end.

Definition is_numeric (p : entry) : bool :=
  match p with Laplace | Taylor | Left _ => false | _ => true end.

Definition pieces_hold (p : plan) (c : block) : bool :=
  if block_in_cell c && forallb (entry_fits c) (entries c) then
    if existsb is_numeric (entries c) then
      match beta_from c with
      | At low =>
          match walk_parts (plan_halvings p) p (cell_of c) (entries c) (low - 1) (beta_to c - 1) with
          | Some signs => forallb (right_fits (cell_of c) signs) (entries c)
          | None => false
          end
      | _ => false
      end
    else true
  else false.

(** ** Statements *)

(** The sign of F that a piece gives, for a statement of a sign. *)
Definition gives_sign (tau : interval) (m : nat) (s : bool) (p : entry) : bool :=
  match p with
  | Laplace | Taylor | Left _ => s
  | Sign _ _ s' => Bool.eqb s s'
  | Hinge _ _ => Bool.eqb s (negb (Nat.eqb (m mod 3) 2)) && negb (interval_holds tau 0)
  | Right _ v => Nat.eqb v 0 && Bool.eqb s (Nat.even m)
  | Monotone _ _ _ | Fold _ _ => false
  end.

Definition sign_block (tau : interval) (s : bool) (p : plan) (c : block) : bool :=
  if covers (map ends_of (entries c)) (interval_from tau) (interval_to tau) && forallb (gives_sign tau (cell_of c) s)
    (entries c)
  then pieces_hold p c else false.

(** The pieces with any numbers: [zeros_counted] looks at the signs only. *)
Definition shape (p : entry) : piece :=
  match p with
  | Laplace => laplace_piece | Taylor => taylor_piece | Left _ => left_piece 0%R | Sign _ _ s => sign_piece 0%R 0%R s
  | Monotone _ _ d => monotone_piece 0%R 0%R d | Fold _ _ => fold_piece 0%R 0%R | Hinge _ _ => hinge_piece 0%R 0%R |
    Right _ v => right_piece 0%R v
  end.

Definition zeros_block (counts : list (nat * nat)) (p : plan) (c : block) : bool :=
  if covers (map ends_of (entries c)) MinusInfinity PlusInfinity &&
    match find (fun e => Nat.eqb (fst e) (cell_of c)) counts,
      zeros_counted (Column m_infty 0%R (cell_of c) []) None None (map shape (entries c)) with
    | Some e, Some n => Nat.eqb (snd e) n
    | _, _ => false
    end
  then pieces_hold p c else false.

Fixpoint on_each (check : plan -> block -> bool) (plans : list plan) (l : list block) : bool :=
  match plans, l with
  | [], [] => true
  | p :: plans, c :: l => if check p c then on_each check plans l else false
  | _, _ => false
  end.

Definition accepts (plans : list plan) (c : certificate) : bool :=
  let columns := map (fun c => (beta_from c, At (beta_to c))) (blocks c) in
  match claimed c with
  | SignClaim tau beta s =>
      if covers columns (interval_from beta) (interval_to beta) then
        if all_positive beta then on_each (sign_block tau (negb s)) plans (blocks c)
        else if all_negative beta then on_each (sign_block tau s) plans (blocks c) else false
      else false
  | ZerosClaim beta counts =>
      if edge_le (At 0) (interval_from beta) && covers columns (interval_from beta) (interval_to beta)
      then on_each (zeros_block counts) plans (blocks c) else false
  end.

(** The claim *zeros* alone, without pieces: the law gives m mod 3 + floor(m/3) zeros for beta in (m, m + 1). The counts
    must be these, and every cell of the range must be listed. *)
Definition counted (c : claim) : bool :=
  match c with
  | ZerosClaim (Interval (At low) (At high) _ _) counts =>
      let first := Z.to_nat (Qfloor low) in
      Qle_bool 0 low && forallb (fun e => Nat.eqb (snd e) (fst e mod 3 + fst e / 3)) counts &&
      forallb (fun m => existsb (Nat.eqb m) (map fst counts)) (seq first (Z.to_nat (Qceiling high) - first))
  | _ => false
  end.
