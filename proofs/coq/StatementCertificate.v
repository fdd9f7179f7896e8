(** * What the pieces of a certificate prove together (proofs/certificate.md): definitions and statements

    This file holds no proof; it is read after [Statement.v] and [StatementCompliant.v], whose words it uses. Each
    statement is proved in [Theorems.v] under the same name. *)

From Coq Require Import Reals List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant.
Import ListNotations.
Open Scope R_scope.

(** ** What the pieces of a certificate prove together (proofs/certificate.md, version 1) *)

(** F b is Theta(., b), for integers b too. *)
Definition theta_family (F : R -> R -> R) : Prop := forall b, is_Theta_entire b (F b).

(** A range of tau or of beta, closed or open at each end. *)
Record range := Range { range_from : Rbar; range_to : Rbar; closed_from : bool; closed_to : bool }.

Definition in_range (r : range) (x : R) : Prop :=
  (if closed_from r then Rbar_le (range_from r) x else Rbar_lt (range_from r) x) /\
  (if closed_to r then Rbar_le x (range_to r) else Rbar_lt x (range_to r)).

(** Closed intervals, each beginning where the one before it ends, cover [start, stop]. *)
Fixpoint cover (parts : list (Rbar * Rbar)) (start stop : Rbar) : Prop :=
  match parts with
  | [] => False
  | (low, high) :: rest => Rbar_le low start /\
      match rest with
      | [] => Rbar_le stop high
      | (next, _) :: _ => next = high /\ cover rest high stop
      end
  end.

(** Signs: [true] is +. *)
Definition signed (s : bool) (x : R) : R := if s then x else - x.

(** A piece as it stands in the file; [right_piece T v] has v changes of sign. *)
Inductive piece :=
| laplace_piece | taylor_piece | left_piece (X : R) | sign_piece (t1 t2 : R) (s : bool)
| monotone_piece (t1 t2 : R) (d : bool) | fold_piece (t1 t2 : R) | hinge_piece (t1 t2 : R)
| right_piece (T : R) (v : nat).

Definition piece_ends (p : piece) : Rbar * Rbar :=
  match p with
  | laplace_piece => (m_infty, p_infty)
  | taylor_piece => (Finite 0, p_infty)
  | left_piece X => (m_infty, Finite X)
  | right_piece T _ => (Finite T, p_infty)
  | sign_piece t1 t2 _ | monotone_piece t1 t2 _ | fold_piece t1 t2 | hinge_piece t1 t2 => (Finite t1, Finite t2)
  end.

(** A column: beta in [low, high], inside the closed cell [m, m + 1]; for m = 0 all beta <= 1. Below b = beta - 1. *)
Record column := Column { column_low : Rbar; column_high : R; column_cell : nat; column_pieces : list piece }.

Definition in_cell (c : column) : Prop :=
  column_high c <= INR (column_cell c) + 1 /\ (column_cell c = 0%nat \/ Rbar_le (INR (column_cell c)) (column_low c)).

Definition in_column (c : column) (b : R) : Prop := Rbar_le (column_low c) (b + 1) /\ b + 1 <= column_high c.

(** The changes in a sequence of signs that begins with s; an open one ([None]) must stand between opposite ones. *)
Fixpoint changes (s : bool) (signs : list (option bool)) : option nat :=
  match signs with
  | [] => Some 0%nat
  | Some s' :: rest => option_map (fun v => if Bool.eqb s s' then v else S v) (changes s' rest)
  | None :: Some s' :: rest => if Bool.eqb s s' then None else option_map S (changes s' rest)
  | None :: _ => None
  end.

(** A finite cover of [t1, t2] x J by boxes on each of which dF/db + w F > 0, with a constant w; at the b inside J. *)
Definition increases_in_b (F : R -> R -> R) (c : column) (t1 t2 : R) : Prop :=
  exists boxes : list ((R * R) * (R * R) * R),
  let inside t b box := let '((s1, s2), (b1, b2), _) := box in s1 <= t <= s2 /\ b1 <= b <= b2 in
  (forall t b, t1 <= t <= t2 -> in_column c b -> exists box, In box boxes /\ inside t b box) /\
  (forall t b box, In box boxes -> inside t b box -> Rbar_lt (column_low c) (b + 1) -> b + 1 < column_high c ->
     0 < Derive (fun b => F b t) b + snd box * F b t).

(** The number at which J has its fold: the end of J that is 2 mod 3. Below it there are two zeros, above it none. *)
Definition fold_above (c : column) : Prop :=
  (column_cell c mod 3 = 2)%nat /\ column_high c = INR (column_cell c) + 1.
Definition fold_below (c : column) : Prop :=
  (column_cell c mod 3 = 0 /\ 3 <= column_cell c)%nat /\ column_low c = INR (column_cell c).

(** What is checked of a piece. *)
Definition piece_checked (F : R -> R -> R) (c : column) (p : piece) : Prop :=
  let m := column_cell c in
  Rbar_lt (fst (piece_ends p)) (snd (piece_ends p)) /\
  match p with
  | laplace_piece | taylor_piece => column_high c <= 1
  | left_piece X => X < 0 /\ Rbar_le 0 (column_low c) /\
      let N := S ((m - 1) / 3) in
      let factor i := Rmax (Rabs (real (column_low c) - 1 - INR i)) (Rabs (column_high c - 1 - INR i)) in
      fold_right Rmult 1 (map factor (seq 0 (3 * N))) < (- X) ^ (3 * N) * 3 ^ N * INR (fact N)
  | sign_piece t1 t2 s => forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed s (F b t)
  | monotone_piece t1 t2 d => forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed d (Derive (F b) t)
  | fold_piece t1 t2 => t1 < 0 < t2 /\ (fold_below c \/ fold_above c) /\
      (forall b, in_column c b -> 0 < F b t1 /\ 0 < F b t2) /\
      (forall t b, t1 <= t <= t2 -> in_column c b -> 0 < Derive_n (F b) 2 t) /\ increases_in_b F c t1 t2
  | hinge_piece t1 t2 => (1 <= m)%nat /\ (t1 = 0 \/ t2 = 0) /\
      let s := negb (Nat.eqb (m mod 3) 2) in
      forall t b, t1 <= t <= t2 -> in_column c b -> 0 < signed (if Rle_dec 0 t1 then s else negb s) (Derive (F b) t)
  | right_piece T v => (1 <= m)%nat /\ (v <= 1)%nat /\ exists s signs, length signs = (m - 1)%nat /\
      changes s (signs ++ [Some (Nat.even m)]) = Some v /\
      (forall b, in_column c b -> 0 < signed s (F b T)) /\
      (forall k s' b, nth k signs None = Some s' -> in_column c b -> 0 < signed s' (Derive_n (F b) (S k) T))
  end.

(** The sign of F that a piece gives: at its ends (at T for [right_piece]), and between them if it holds no zero. *)
Definition piece_sign (c : column) (p : piece) : option bool :=
  match p with
  | laplace_piece | taylor_piece | left_piece _ | fold_piece _ _ => Some true
  | sign_piece _ _ s => Some s
  | monotone_piece _ _ _ => None
  | hinge_piece _ _ => Some (negb (Nat.eqb (column_cell c mod 3) 2))
  | right_piece _ v => Some (Nat.even (column_cell c + v))
  end.

(** The pieces of a column that is accepted for dTheta/dtau of sign s on a range of tau: F has the sign s' = s or -
    s. *)
Definition sign_column (F : R -> R -> R) (tau beta : range) (s' : bool) (c : column) : Prop :=
  in_cell c /\ cover (map piece_ends (column_pieces c)) (range_from tau) (range_to tau) /\
  forall p, In p (column_pieces c) -> piece_checked F c p /\ piece_sign c p = Some s' /\
    match p with
    | right_piece _ v => v = 0%nat
    | fold_piece _ _ | hinge_piece _ _ =>
        (match p with fold_piece _ _ => exists n : nat, (n mod 3 = 0)%nat /\ column_low c = INR n | _ => True end) /\
        ~ (in_range tau 0 /\ exists n : nat, (n mod 3 <> 1)%nat /\ in_column c (INR n - 1) /\ in_range beta (INR n))
    | _ => True
    end.

(** A certificate of a sign: dTheta/dtau = - beta F has the sign s at every tau and beta of two ranges. *)
Definition sign_certificate : Prop := forall F tau beta columns s, theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  ((forall x, in_range beta x -> 0 < x) /\ (forall c, In c columns -> sign_column F tau beta (negb s) c) \/
   (forall x, in_range beta x -> x < 0) /\ (forall c, In c columns -> sign_column F tau beta s c)) ->
  forall t b, in_range tau t -> in_range beta b -> 0 < signed s (Derive (F b) t).

(** The walk through the pieces of a column: [before] is the sign of F at the end of the last piece that fixes one, and
    [run] the direction of the pieces [monotone] since then; a fold at the upper end of J holds two zeros, [right] holds
    v. *)
Definition crossings (before run : option bool) (s : bool) : option nat :=
  match before with
  | None => Some 0%nat
  | Some s' =>
      if Bool.eqb s' s then Some 0%nat
      else match run with Some d => if Bool.eqb d s then Some 1%nat else None | None => None end
  end.

Definition zeros_inside (c : column) (p : piece) : nat :=
  match p with
  | fold_piece _ _ => if Nat.eqb (column_cell c mod 3) 2 then 2 else 0
  | right_piece _ v => v
  | _ => 0
  end.

Fixpoint zeros_counted (c : column) (before run : option bool) (pieces : list piece) : option nat :=
  match pieces with
  | [] => match run with None => Some 0%nat | Some _ => None end
  | hinge_piece _ _ :: _ => None
  | monotone_piece _ _ d :: rest =>
      match before, run with
      | None, _ => None
      | Some _, Some d' => if Bool.eqb d d' then zeros_counted c before run rest else None
      | Some _, None => zeros_counted c before (Some d) rest
      end
  | p :: rest =>
      match piece_sign c p with
      | None => None
      | Some s =>
          match crossings before run s, zeros_counted c (Some s) None rest with
          | Some k, Some l => Some (k + zeros_inside c p + l)%nat
          | _, _ => None
          end
      end
  end.

Definition zeros_column (F : R -> R -> R) (count : nat) (c : column) : Prop :=
  in_cell c /\ cover (map piece_ends (column_pieces c)) m_infty p_infty /\
  (forall p, In p (column_pieces c) -> piece_checked F c p) /\ zeros_counted c None None (column_pieces c) = Some count.

(** A certificate of the number of zeros: exactly [count m] real zeros of dTheta/dtau for every beta of the range in (m,
    m + 1), all simple. *)
Definition zeros_certificate : Prop := forall F beta columns (count : nat -> nat), theta_family F ->
  cover (map (fun c => (column_low c, Finite (column_high c))) columns) (range_from beta) (range_to beta) ->
  (forall c, In c columns -> zeros_column F (count (column_cell c)) c) ->
  forall (m : nat) b, in_range beta b -> INR m < b < INR m + 1 ->
    exists l, zeros_of (Derive (F b)) l /\ length l = count m /\ forall t, In t l -> Derive_n (F b) 2 t <> 0.

(** A certificate of brackets: as many zeros as brackets, and one in each. *)
Definition brackets_certificate : Prop := forall F b c (brackets : list (R * R)), theta_family F -> 0 < b ->
  not_nat b ->
  in_column c (b - 1) -> zeros_column F (length brackets) c ->
  StronglySorted (fun one two => snd one <= fst two) brackets ->
  (forall lo hi, In (lo, hi) brackets -> lo < hi /\ F (b - 1) lo * F (b - 1) hi < 0) ->
  exists l, zeros_of (Derive (F b)) l /\ length l = length brackets /\ (forall t, In t l -> Derive_n (F b) 2 t <> 0) /\
    forall i, (i < length l)%nat -> fst (nth i brackets (0, 0)) < nth i l 0 < snd (nth i brackets (0, 0)).

(** Version 2, the contact force of the compliant model at one beta: the column is that point, and beside the pieces
    that give F the sign (-1)^floor(beta) there are [level] pieces (t1, t2), on which |F| is at most the level. *)
Definition force_column (F : R -> R -> R) (beta level : R) (tau : range) (c : column) (parts : list (piece + R * R))
  : Prop :=
  in_cell c /\ column_low c = Finite beta /\ column_high c = beta /\
  cover (map (fun part => match part with inl p => piece_ends p | inr (t1, t2) => (Finite t1, Finite t2) end) parts)
    (range_from tau) (range_to tau) /\
  forall part, In part parts ->
    match part with
    | inl p => piece_checked F c p /\ piece_sign c p = Some (Nat.even (column_cell c)) /\
        match p with left_piece _ | sign_piece _ _ _ => True | right_piece _ v => v = 0%nat | _ => False end
    | inr (t1, t2) => forall t, t1 <= t <= t2 -> Rabs (F (beta - 1) t) <= level
    end.

(** What is compared with 1: the 3n-th power of (the deviation of the force at this level)/(its mean), beta - 1 =
    h/n. *)
Definition compared (a1 a2 a3 C1 eps level : R) (h n : nat) : R :=
  (Rabs (C1 / a3) * (a3 / a1) * level / (a2 / (a3 - a1))) ^ (3 * n) * (2 * eps ^ 2 / - a1) ^ h.

(** On the slow manifold the force is positive at every tau of a range and every eps up to eps_0. *)
Definition force_certificate : Prop := forall F a1 a2 a3 C1 eps0 level h n tau c parts, theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> not_nat (a3 / a1) -> 1 < a3 / a1 < 5 ->
  0 < eps0 -> 0 < level -> 0 < C1 * Gamma (- (a3 / a1)) -> compared a1 a2 a3 C1 eps0 level h n <= 1 ->
  force_column F (a3 / a1) level tau c parts ->
  forall eps p b y v z t, 0 < eps <= eps0 -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    in_range tau (Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3)) -> 0 < linear_force eps (y t) (z t).

(** On the other side it is negative at one tau, for every eps from eps_1 on. *)
Definition lift_off_certificate : Prop := forall F a1 a2 a3 C1 eps1 level h n m tau1, theta_family F ->
  a1 < 0 -> a2 < 0 -> a3 < 0 -> (0 < n)%nat -> a3 / a1 = 1 + INR h / INR n -> INR m < a3 / a1 < INR m + 1 ->
    1 < a3 / a1 < 5 ->
  0 < eps1 -> 0 < level -> C1 * Gamma (- (a3 / a1)) < 0 -> 1 <= compared a1 a2 a3 C1 eps1 level h n ->
  level <= signed (Nat.even m) (F (a3 / a1 - 1) tau1) ->
  forall eps p b y v z t, eps1 <= eps -> slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) p b y v z ->
    Rpower (- a1 / 2) (1 / 3) * t * Rpower eps (- 2 / 3) = tau1 -> linear_force eps (y t) (z t) < 0.

(** Version 3, the number of zeros of the force less its mean, 4 < beta < 5: each column, beta in [low, high], is one
    piece dip (t1, t2). *)
Definition dip_checked (F : R -> R -> R) (eta0 : R) (low high t1 t2 : R) : Prop :=
  0 < t1 < t2 /\ 2 * t1 ^ 3 <= t2 ^ 3 /\
  let mu := t1 / t2 in
  forall b, low <= b + 1 <= high ->
    F b t1 + 3 * eta0 / (8 * (1 - mu ^ 3)) * (Rpower mu (b - 1) * Derive (F b) t2 - Derive (F b) t1) < 0.

(** For every beta of the range, neither 4 nor 5, and every eps up to eps_0 (of the normal form a1 = -1: in general -a1
    eps) the force of a slow motion with C <> 0 is equal to its mean exactly twice; both zeros of the difference are
    simple. *)
Definition slow_zeros_certificate : Prop := forall F beta columns eps0 eta0, theta_family F ->
  (forall x, in_range beta x -> 4 <= x <= 5) -> 0 < eta0 -> eps0 <= 2 * eta0 ^ 3 ->
  cover (map (fun c => match c with (low, high, _, _) => (Finite low, Finite high) end) columns)
    (range_from beta) (range_to beta) ->
  (forall low high t1 t2, In (low, high, t1, t2) columns -> dip_checked F eta0 low high t1 t2) ->
  forall a1 a2 a3 eps C p b y v z, parameters a1 a3 eps -> in_range beta (a3 / a1) -> - a1 * eps <= eps0 -> C <> 0 ->
    slow_motion a1 a2 a3 eps C p b y v z ->
    exists s t, s < t /\ simple_zeros (fun t => linear_force eps (y t) (z t) - a2 / (a3 - a1)) [s; t].
