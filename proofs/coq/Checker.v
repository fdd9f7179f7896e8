(** * A checker of certificates: what it computes

    Integers and rationals only; [CheckerSound.v] proves that what it accepts is true, so nothing here has to be
    believed. It follows proofs/check.md: b = (centre + radius eta)/unit with |eta| <= 1; F/x^b is carried along t from
    -x. *)

From Coq Require Import ZArith QArith Qabs Qreduction List Bool.
Import ListNotations.
Open Scope Z_scope.

(** ** Models: sum_i rho_i P_i(eta), up to an error, |rho_i| <= 1 *)

Definition poly := list Z.

Fixpoint poly_plus (p q : poly) : poly :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | a :: p, b :: q => a + b :: poly_plus p q
  end.

Definition poly_times (n : Z) (p : poly) : poly := map (Z.mul n) p.

(** (n + r eta) p *)
Definition poly_linear (n r : Z) (p : poly) : poly := poly_plus (poly_times n p) (0 :: poly_times r p).

Definition poly_norm (p : poly) : Z := fold_right (fun z s => Z.abs z + s) 0 p.

Record model := Model { parts : list poly; error : Z }.

Fixpoint parts_plus (p q : list poly) : list poly :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | a :: p, b :: q => poly_plus a b :: parts_plus p q
  end.

Definition parts_norm (p : list poly) : Z := fold_right (fun a s => poly_norm a + s) 0 p.

Definition model_plus (m m' : model) : model := Model (parts_plus (parts m) (parts m')) (error m + error m').

Definition model_times (n : Z) (m : model) : model := Model (map (poly_times n) (parts m)) (Z.abs n * error m).

Definition model_linear (n r : Z) (m : model) : model :=
  Model (map (poly_linear n r) (parts m)) ((Z.abs n + Z.abs r) * error m).

(** Division by d > 0, rounded; of the i-th polynomial the first [nth i degrees] coefficients are kept. *)
Fixpoint kept (d : Z) (degrees : list nat) (p : list poly) : list poly :=
  match degrees, p with
  | n :: degrees, a :: p => map (fun z => z / d) (firstn n a) :: kept d degrees p
  | _, _ => []
  end.

Fixpoint dropped (degrees : list nat) (p : list poly) : Z :=
  match degrees, p with
  | n :: degrees, a :: p => poly_norm (skipn n a) + dropped degrees p
  | _, p => parts_norm p
  end.

Definition count_coefficients (p : list poly) : Z := fold_right (fun a s => Z.of_nat (length a) + s) 0 p.

Definition shrink (degrees : list nat) (d : Z) (m : model) : model :=
  let small := kept d degrees (parts m) in
  Model small ((error m + dropped degrees (parts m)) / d + 1 + count_coefficients small).

(** A bound on the absolute value. *)
Definition model_norm (m : model) : Z := parts_norm (parts m) + error m.

(** The sign, if it is certain after a change by at most [rest]: that of the constant term. *)
Definition sign_of (rest : Z) (m : model) : option bool :=
  match parts m with
  | (z :: a) :: p =>
      let other := poly_norm a + parts_norm p + error m + rest in
      if other <? z then Some true else if other <? - z then Some false else None
  | _ => None
  end.

(** ** The range of b *)

Record setting := Setting { b_unit : Z; b_centre : Z; b_radius : Z; b_most : Z; kept_degrees : list nat }.

(** (i - b) y *)
Definition minus_b (g : setting) (i factor : Z) (m : model) : model :=
  model_linear (factor * (i * b_unit g - b_centre g)) (- (factor * b_radius g)) m.

(** ** The start at -x: y, x y', x^2 y'' *)

Record state := State { point : Q; scale : Q; value0 : model; value1 : model; value2 : model }.

(** The terms t_k, t_k (3k - b), t_k (3k - b)(3k + 1 - b). *)
Definition once (g : setting) (k : Z) (term : model) : model := shrink (kept_degrees g) (b_unit g)
  (minus_b g (3 * k) 1 term).
Definition twice (g : setting) (k : Z) (term : model) : model :=
  shrink (kept_degrees g) (b_unit g) (minus_b g (3 * k + 1) 1 (once g k term)).
Definition next_term (g : setting) (x k : Z) (term : model) : model :=
  model_times (-1) (shrink (kept_degrees g) (b_unit g * (3 * (k + 1) * x ^ 3))
    (minus_b g (3 * k + 2) 1 (twice g k term))).

Definition zero_model : model := Model [] 0.

(** Half of a term that is left out: y = (sum + half) + rho half, rho in the i-th place. *)
Definition rest_at (i : nat) (g : setting) (term : model) : model :=
  let half := shrink (kept_degrees g) 2 term in
  let own := hd [] (parts half) in
  let others := parts_norm (tl (parts half)) in
  Model (own :: repeat [] i ++ [own]) (2 * (error half + others)).

(** Sums of [count] terms from the k-th on, and the first one left out. *)
Fixpoint terms (count : nat) (g : setting) (x k : Z) (term sum0 sum1 sum2 : model) : model * model * model * model :=
  match count with
  | O => (term, sum0, sum1, sum2)
  | S count => terms count g x (k + 1) (next_term g x k term)
      (model_plus sum0 term) (model_plus sum1 (once g k term)) (model_plus sum2 (twice g k term))
  end.

Definition start (count : nat) (g : setting) (x one : Z) : state :=
  let '(term, sum0, sum1, sum2) := terms count g x 0 (Model [[one]] 0) zero_model zero_model zero_model in
  let k := Z.of_nat count in
  State (inject_Z (- x)) (inject_Z x) (model_plus sum0 (rest_at 0 g term))
    (model_plus sum1 (rest_at 1 g (once g k term)))
    (model_plus sum2 (rest_at 2 g (twice g k term))).

(** ** Taylor coefficients *)

(** A rational multiple. *)
Definition multiple (g : setting) (q : Q) (m : model) : model := shrink (kept_degrees g) (Zpos (Qden q))
  (model_times (Qnum q) m).

(** t s^2 = square/common and s^3/unit = cube/common *)
Record step := Step { square : Z; cube : Z; common : Z }.

Definition step_of (g : setting) (t s : Q) : step :=
  let one := Qred (t * s * s) in
  let two := Qred (s * s * s / inject_Z (b_unit g)) in
  let common := Z.lcm (Zpos (Qden one)) (Zpos (Qden two)) in
  Step (Qnum one * (common / Zpos (Qden one))) (Qnum two * (common / Zpos (Qden two))) common.

Definition step_is_right (g : setting) (t s : Q) (e : step) : bool :=
  match common e with
  | Zpos d => Qeq_bool (square e # d) (t * s * s) && Qeq_bool (cube e # d) (s * s * s / inject_Z (b_unit g))
  | _ => false
  end.

(** a_(k+3) = (t s^2 (k + 1) a_(k+1) + s^3 (k - b) a_k)/((k + 1)(k + 2)(k + 3)) *)
Definition next_coefficient (g : setting) (e : step) (k : Z) (a0 a1 : model) : model :=
  shrink (kept_degrees g) (common e * ((k + 1) * (k + 2) * (k + 3)))
    (model_plus (model_times (square e * (k + 1)) a1) (minus_b g k (cube e) a0)).

(** a_k, a_(k+1), a_(k+2), ... until three of them are small. *)
Fixpoint coefficients (fuel : nat) (g : setting) (e : step) (small k : Z) (a0 a1 a2 : model) : list model :=
  match fuel with
  | O => [a0; a1; a2]
  | S fuel =>
      if (model_norm a0 <=? small) && (model_norm a1 <=? small) && (model_norm a2 <=? small) then [a0; a1; a2]
      else a0 :: coefficients fuel g e small (k + 1) a1 a2 (next_coefficient g e k a0 a1)
  end.

(** k a_k, k >= 1: the coefficients of s y'. *)
Fixpoint slopes_from (k : Z) (l : list model) : list model :=
  match l with
  | [] => []
  | a :: l => model_times k a :: slopes_from (k + 1) l
  end.

Definition slopes (l : list model) : list model := slopes_from 1 (tl l).

(** q(n - 3) <= 1/2: the coefficients from the n-th on are together at most three times the greatest of the last
    three. *)
Definition tail_is_small (b : Z) (t s : Q) (n : nat) : bool :=
  let i := inject_Z (Z.of_nat n - 3) in
  (3 <=? Z.of_nat n) && Qle_bool (2 * (Qabs t * s * s * (i + 1) + (i + inject_Z b) * s * s * s))
    ((i + 1) * (i + 2) * (i + 3)).

Definition tail_bound (l : list model) : Z :=
  3 * fold_right (fun a m => Z.max (model_norm a) m) 0 (skipn (length l - 3) l).

(** The sum at the distance s. *)
Definition total (g : setting) (t s : Q) (l : list model) : option model :=
  if tail_is_small (b_most g) t s (length l) then
    let sum := fold_right model_plus zero_model l in Some (Model (parts sum) (error sum + tail_bound l))
  else None.

(** The sign on [t - s, t + s]. *)
Definition sign_on (g : setting) (t s : Q) (l : list model) : option bool :=
  if tail_is_small (b_most g) t s (length l) then
    match l with
    | [] => None
    | a :: l' => sign_of (fold_right (fun a s => model_norm a + s) 0 l' + tail_bound l) a
    end
  else None.

(** ** Along t *)

Record effort := Effort { longest : nat; small_enough : Z; step_length : Q; halvings : nat; most_steps : nat }.

Definition expand (g : setting) (w : effort) (st : state) (s : Q) : option (list model) :=
  let e := step_of g (point st) s in
  let r := Qred (s / scale st) in
  if step_is_right g (point st) s e && Qle_bool (scale st * r) s && Qle_bool s (scale st * r) then
    Some (coefficients (longest w) g e (small_enough w) 0 (value0 st) (multiple g r (value1 st))
      (multiple g (Qred (r * r / 2)) (value2 st)))
  else None.

Definition is_positive (q : Q) : bool := 0 <? Qnum q.

Definition carry (g : setting) (w : effort) (st : state) (s : Q) : option state :=
  if is_positive s then
    match expand g w st s with
    | None => None
    | Some l =>
        match total g (point st) s l, total g (point st) s (slopes l), total g (point st) s (slopes (slopes l)) with
        | Some v0, Some v1, Some v2 =>
            let all := shrink (kept_degrees g) 1 in
            Some (State (Qred (point st + s)) s (all v0) (all v1) (all v2))
        | _, _, _ => None
        end
    end
  else None.

Fixpoint advance (fuel : nat) (g : setting) (w : effort) (target : Q) (st : state) : option state :=
  if Qeq_bool target (point st) then Some st
  else
    match fuel with
    | O => None
    | S fuel =>
        let distance := Qred (target - point st) in
        match carry g w st (if Qle_bool distance (step_length w) then distance else step_length w) with
        | Some st' => advance fuel g w target st'
        | None => None
        end
    end.

(** The sign s of the function (order 0) or of its slope (order 1) on [t1, t2], which is cut where needed. *)
Fixpoint has_sign (cuts : nat) (g : setting) (w : effort) (order : nat) (s : bool) (t1 t2 : Q) (st : state)
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
              match sign_on g middle half (if Nat.eqb order 0 then l else slopes l) with
              | Some s' => if Bool.eqb s s' then Some st' else None
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
          match has_sign cuts g w order s t1 middle st with
          | Some st' => has_sign cuts g w order s middle t2 st'
          | None => None
          end
      end
  end.
