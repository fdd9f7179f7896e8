(** * A checker of runs: what it computes

    Integers and rationals only; [RunSound.v] proves that what it accepts is true, so nothing here has to be believed.
    It follows proofs/run_certificate.md, for the first phase of a run of the model system with k_1 = k_2 = damping = 1
    and a known p: steps along polynomials, bounds of the errors in blocks of a basis, the sign of lambda = Z - Y on
    each step, and the lift-off in the last one. p is a known function of time, so the equations are linear with a
    matrix that is affine in p, and no box of states is needed. Units: of the time T = t/eps 1/clock, of the polynomials
    1/grain, of errors 1/(grain fine), of what is computed of matrices 1/scale, of the bracket, in tau, 1/ticks. *)

From Coq Require Import ZArith QArith List Bool.
From GSpot Require Import Checker CompliantMotion RunScene.
Import ListNotations.
Open Scope Z_scope.

(** ** Vectors: numbers for b, y, v, z, or for the columns of a basis *)
Definition vector (A : Type) : Type := coordinate -> A.
Definition matrix : Type := vector (vector Z).

Definition row {A : Type} (b y v z : A) : vector A :=
  fun i => match i with of_b => b | of_y => y | of_v => v | of_z => z end.

(** The same vector, computed once. *)
Definition stored {A : Type} (f : vector A) : vector A := row (f of_b) (f of_y) (f of_v) (f of_z).

Definition sum (f : vector Z) : Z := f of_b + (f of_y + (f of_v + (f of_z + 0))).
Definition every (f : coordinate -> bool) : bool := f of_b && f of_y && f of_v && f of_z.
Definition largest (f : vector Z) : Z := Z.max (Z.max (f of_b) (f of_y)) (Z.max (f of_v) (f of_z)).

Definition same (i j : coordinate) : bool :=
  match i, j with of_b, of_b | of_y, of_y | of_v, of_v | of_z, of_z => true | _, _ => false end.

(** A column lies in the block that bears the name of one of them. *)
Definition lies (blocks : vector coordinate) (k i : coordinate) : bool := same (blocks i) k.
Definition sum_over (blocks : vector coordinate) (k : coordinate) (f : vector Z) : Z :=
  sum (fun i => if lies blocks k i then f i else 0).

(** Quotient and square root, rounded up. *)
Definition up (a d : Z) : Z := - ((- a) / d).

(** ** What is given *)

(** eps alpha1, eps alpha2, eps alpha1 beta and p0 with one denominator. *)
Record rates := Rates { below : Z; rate1 : Z; rate2 : Z; rate3 : Z; first_p : Z }.

Record piece := Piece { right_end : Z; basis : matrix; inverse : matrix; determinant : Z; blocks : vector coordinate;
  nodes : list (vector Z) }.

Record step := Step { duration : Z; curve : vector poly; pieces : list piece }.

Record run := Run { its_rates : rates; clock : Z; grain : Z; fine : Z; scale : Z; ticks : Z; steps : list step;
  left_tick : Z; right_tick : Z; halvings : nat; depth : nat }.

(** ** Polynomials *)
Fixpoint derivative (p : poly) : poly :=
  match p with [] => [] | _ :: p => poly_plus p (0 :: derivative p) end.

(** 2^(n-1) p(tau/2), n coefficients; p(tau + 1). *)
Fixpoint halved (p : poly) : poly :=
  match p with [] => [] | a :: p => a * 2 ^ Z.of_nat (length p) :: halved p end.
Fixpoint shifted (p : poly) : poly :=
  match p with [] => [] | a :: p => poly_plus [a] (poly_linear 1 1 (shifted p)) end.

Definition least (p : poly) : Z :=
  match p with [] => 0 | a :: p => a + fold_right (fun c s => Z.min c 0 + s) 0 p end.

(** p > 0 on [0, 1], by halving. *)
Fixpoint positive (depth : nat) (p : poly) : bool :=
  if 0 <? least p then true else match depth with O => false | S depth =>
    let h := halved p in if positive depth h then positive depth (shifted h) else false end.

(** p(at/ticks), each product rounded down. *)
Fixpoint rounded_value (ticks at_tick : Z) (p : poly) : Z :=
  match p with [] => 0 | a :: p => a + at_tick * rounded_value ticks at_tick p / ticks end.

Definition less (p : poly) (c : Z) : poly := poly_plus p [- c].
Definition minus (p q : poly) : poly := poly_plus p (poly_times (-1) q).

Section Run.
Variable r : run.
Let rt := its_rates r.
(** The unit of errors is 1/unit. *)
Definition unit : Z := grain r * fine r.

Section Step.
(** The time T at which it begins, and its length. *)
Variables (begin : Z) (s : step).
Let h := duration s.
Let x := curve s.

(** p = (slope tau + value)/(below clock) *)
Definition p_value : Z := first_p rt * clock r + rate1 rt * begin.
Definition p_slope : Z := rate1 rt * h.
Definition force : poly := minus (x of_z) (x of_y).

(** h f(x) - x', times below clock grain, or clock grain. *)
Definition residual_v : poly :=
  minus (poly_times h (poly_plus (poly_times (below rt * clock r) (x of_b)) (poly_linear p_value p_slope force)))
    (poly_times (clock r * (below rt * clock r)) (derivative (x of_v))).
Definition residual_y : poly := minus (poly_times h (x of_v)) (poly_times (clock r) (derivative (x of_y))).
Definition residual_z : poly :=
  minus (poly_times h (minus (x of_y) (poly_times 2 (x of_z)))) (poly_times (clock r) (derivative (x of_z))).
Definition residual_b : poly :=
  minus (poly_times h (minus [rate2 rt * grain r] (poly_times (rate3 rt) force)))
    (poly_times (below rt * clock r) (derivative (x of_b))).

(** Bounds of the defect. *)
Definition defects : vector Z := stored (row
  (up (poly_norm residual_b * fine r) (below rt * clock r)) (up (poly_norm residual_y * fine r) (clock r))
  (up (poly_norm residual_v * fine r) (clock r * (below rt * clock r))) (up (poly_norm residual_z * fine r) (clock r))).

(** ** One piece *)

(** Errors are S zeta, and the length of block k of zeta is at most [radii k]. *)
Record errors := Errors { its_basis : matrix; its_blocks : vector coordinate; radii : vector Z }.

Section Piece.
Variables (defect : vector Z) (left_end : Z) (before : errors) (jump : vector Z) (c : piece).
Let S := basis c.
Let inv := inverse c.
Let det := determinant c.
Let bl := blocks c.

(** p is within p_radius of p_middle, times p_below. *)
Definition p_below : Z := 2 * (below rt * clock r) * clock r.
Definition p_middle : Z := 2 * (p_value * clock r) + p_slope * (left_end + right_end c).
Definition p_radius : Z := Z.abs p_slope * (right_end c - left_end).

(** The matrix of the equations at p_middle, times p_below, times S; then B = S^-1 A S. *)
Definition field_times (l : coordinate) : vector Z := stored (row
  (2 * (clock r * clock r) * rate3 rt * (S of_y l - S of_z l))
  (p_below * S of_v l)
  (p_middle * (S of_z l - S of_y l) + p_below * S of_b l)
  (p_below * (S of_y l - 2 * S of_z l))).
Definition turned : matrix :=
  let columns := stored field_times in stored (fun i => stored (fun l => sum (fun m => inv i m * columns l m))).
Definition turned_radius : matrix :=
  stored (fun i => stored (fun l => Z.abs (inv i of_v) * Z.abs (S of_z l - S of_y l) * p_radius)).

Definition is_inverse : bool :=
  every (fun i => every (fun l => sum (fun m => S i m * inv m l) =? if same i l then det else 0)).

(** A matrix like M of Theorem N1': any one that passes [growth_bounded] will do; this is the least. *)
Section Growth.
Variables (B E : matrix).
Definition sizes : matrix :=
  stored (fun i => stored (fun l => up ((Z.abs (B i l) + E i l) * scale r) (det * p_below))).
Definition disc (j i : coordinate) : Z :=
  up ((B i i + E i i) * scale r) (det * p_below)
  + up (sum_over bl j (fun l => if same i l then 0 else
      up ((Z.abs (B i l + B l i) + (E i l + E l i)) * scale r) (det * p_below))) 2.
Definition squares (C : matrix) (j k : coordinate) : Z :=
  sum_over bl j (fun i => sum_over bl k (fun l => C i l * C i l)).
Definition growth : matrix :=
  let C := sizes in
  stored (fun j => stored (fun k =>
    if same j k then largest (fun i => if lies bl j i then disc j i else disc j j) else Z.sqrt_up (squares C j k))).
Definition growth_bounded (M : matrix) : bool :=
  let C := sizes in
  every (fun j => every (fun k =>
    if same j k then every (fun i => implb (lies bl j i) (disc j i <=? M j j))
    else (0 <=? M j k) && (squares C j k <=? M j k * M j k))).
End Growth.

(** Lengths of the blocks of S^-1 times a vector: of one with these components, and of all with components of at most
    these sizes. *)
Definition turned_jump : vector Z := stored (fun i => up (Z.abs (sum (fun l => inv i l * jump l))) det).
Definition turned_defect : vector Z := stored (fun i => up (sum (fun l => Z.abs (inv i l) * defect l)) det).
Definition lengths (v : vector Z) : vector Z := stored (fun j => Z.sqrt_up (sum_over bl j (fun i => v i * v i))).
Definition lengths_bounded (v d : vector Z) : bool :=
  every (fun j => (0 <=? d j) && (sum_over bl j (fun i => v i * v i) <=? d j * d j)).

(** S^-1 times the basis before, times det; norms of its blocks, from the row sums of G'G. *)
Definition change : matrix :=
  let old := its_basis before in stored (fun i => stored (fun l => sum (fun m => inv i m * old m l))).
Definition gram_sum (G : matrix) (j k a : coordinate) : Z :=
  sum_over (its_blocks before) k (fun b => Z.abs (sum_over bl j (fun i => G i a * G i b))).
Definition norms (G : matrix) : matrix :=
  stored (fun j => stored (fun k => Z.sqrt_up (up (scale r * scale r *
    largest (fun a => if lies (its_blocks before) k a then gram_sum G j k a else 0)) (det * det)))).
Definition norms_bounded (G N : matrix) : bool :=
  every (fun j => every (fun k => (0 <=? N j k) && every (fun a => implb (lies (its_blocks before) k a)
    (scale r * scale r * gram_sum G j k a <=? N j k * N j k * (det * det))))).

(** Theorem N2: the first node is not below the errors. *)
Definition entered (N : matrix) (d w : vector Z) : bool :=
  every (fun j => sum (fun k => N j k * radii before k) + d j * scale r <=? w j * scale r).

(** (1) of Theorem N1', with K parts. *)
Definition rises (M : matrix) (d : vector Z) (K : Z) (u w v : vector Z) : bool :=
  let long := right_end c - left_end in let most := K * (scale r * (clock r * clock r)) in
  every (fun j => long * (h * sum (fun k => M j k * w k) + d j * (scale r * clock r)) <=? (v j - u j) * most).
Definition all_positive (w : vector Z) : bool := every (fun j => 0 <? w j).
Fixpoint majorant (M : matrix) (d : vector Z) (K : Z) (u : vector Z) (rest : list (vector Z)) : bool :=
  match rest with
  | [] => all_positive u
  | v :: rest => all_positive u && rises M d K u u v && rises M d K u v v && majorant M d K v rest
  end.

Fixpoint final (u : vector Z) (rest : list (vector Z)) : vector Z :=
  match rest with [] => u | v :: rest => final v rest end.
Fixpoint highest (u : vector Z) (rest : list (vector Z)) : vector Z :=
  match rest with [] => u | v :: rest => let later := highest v rest in stored (fun j => Z.max (u j) (later j)) end.
Definition reach (w : vector Z) : vector Z := stored (fun i => sum (fun l => Z.abs (S i l) * w (bl l))).

(** The errors at the end of the piece, and bounds of the components of the error on it. *)
Definition one_piece : option (errors * vector Z) :=
  match nodes c with
  | [] => None
  | u :: rest =>
      let B := turned in let E := turned_radius in let M := growth B E in
      let d := lengths turned_defect in let G := change in let N := norms G in
      let j := lengths turned_jump in
      if (0 <? det) && (0 <? Z.of_nat (length rest)) && (left_end <? right_end c) && is_inverse && growth_bounded B E M
        && lengths_bounded turned_defect d && lengths_bounded turned_jump j && norms_bounded G N && entered N j u
        && majorant M d (Z.of_nat (length rest)) u rest
      then Some (Errors S bl (final u rest), reach (highest u rest)) else None
  end.
End Piece.

(** ** One step *)
Definition no_jump : vector Z := row 0 0 0 0.

Fixpoint all_pieces (defect : vector Z) (left_end : Z) (before : errors) (jump tube : vector Z) (l : list piece)
    : option (errors * vector Z) :=
  match l with
  | [] => if left_end =? clock r then Some (before, tube) else None
  | c :: l => match one_piece defect left_end before jump c with
      | Some (after, w) => if right_end c <=? clock r then
          all_pieces defect (right_end c) after no_jump (stored (fun i => Z.max (tube i) (w i))) l else None
      | None => None
      end
  end.

Definition start_of : vector Z := stored (fun i => hd 0 (x i)).
Definition end_of : vector Z := stored (fun i => fold_right Z.add 0 (x i)).

(** [middle] is the point about which the errors before are. *)
Definition one_step (before : errors) (middle : vector Z) : option (errors * vector Z) :=
  let f := start_of in
  if 0 <? h then
    all_pieces defects 0 before (stored (fun i => (middle i - f i) * fine r)) no_jump (pieces s)
  else None.

(** lambda > 0 on the whole step. *)
Definition in_contact (tube : vector Z) : bool :=
  positive (depth r) (less force (up (tube of_z + tube of_y) (fine r))).

(** lambda falls up to 2^-halvings, is > 0 at the left tick and < 0 at the right one, and the times are in the
    bracket. *)
Definition falling : poly := minus (x of_v) (minus (x of_y) (poly_times 2 (x of_z))).
Definition time_at (tick : Z) : Q := inject_Z (begin * ticks r + h * tick).
Definition lifts_off (g : scene) (tube : vector Z) : bool :=
  let d := up (tube of_z + tube of_y) (fine r) in
  let n := Z.of_nat (length force) in
  let L := left_tick r in let R := right_tick r in
  (0 <? ticks r) && (0 <? L) && (L <? R) && (R * 2 ^ Z.of_nat (halvings r) <=? ticks r)
  && positive (depth r) (Nat.iter (halvings r) halved
      (less falling (up (tube of_v + tube of_y + 2 * tube of_z) (fine r))))
  && (d + n <? rounded_value (ticks r) L force) && (rounded_value (ticks r) R force <? - (d + n))
  && Qle_bool (low g * inject_Z (clock r * ticks r)) (eps g * time_at L)
  && Qle_bool (eps g * time_at R) (high g * inject_Z (clock r * ticks r)).
End Step.

(** ** The run *)
Fixpoint all_steps (g : scene) (begin : Z) (before : errors) (middle : vector Z) (l : list step) : bool :=
  match l with
  | [] => false
  | s :: rest => match one_step begin s before middle with
      | None => false
      | Some (after, tube) =>
          match rest with
          | [] => lifts_off begin s g tube
          | _ => if in_contact s tube then all_steps g (begin + duration s) after (end_of s) rest else false
          end
      end
  end.

(** The numbers of the scene with one denominator. *)
Definition same_rates (g : scene) : bool :=
  (0 <? below rt)
  && Qeq_bool (eps g * alpha1 g * inject_Z (below rt)) (inject_Z (rate1 rt))
  && Qeq_bool (eps g * alpha2 g * inject_Z (below rt)) (inject_Z (rate2 rt))
  && Qeq_bool (eps g * (alpha1 g * beta g) * inject_Z (below rt)) (inject_Z (rate3 rt))
  && Qeq_bool (p0 g * inject_Z (below rt)) (inject_Z (first_p rt)).

(** Where the first polynomials begin, and how far from there the start is, in the unit of errors. *)
Definition first_middle : vector Z := match steps r with [] => row 0 0 0 0 | s :: _ => start_of s end.
Definition away (q : Q) (m : Z) : Z :=
  let d := ((q * inject_Z (grain r) - inject_Z m) * inject_Z (fine r))%Q in up (Z.abs (Qnum d)) (QDen d).
Definition first_errors (g : scene) : errors :=
  let m := first_middle in let e := eps g in
  Errors (fun i l => if same i l then 1 else 0) (fun i => i)
    (row (away (b0 g) (m of_b)) (away (y0 g / (e * e)) (m of_y)) (away (v0 g / e) (m of_v))
      (away (z0 g / (e * e)) (m of_z))).

Definition numbers_fit (g : scene) : bool :=
  (0 <? clock r) && (0 <? grain r) && (0 <? fine r) && (0 <? scale r) && negb (Qle_bool (eps g) 0) && same_rates g.
Definition run_accepted (g : scene) : bool :=
  if numbers_fit g then all_steps g 0 (first_errors g) first_middle (steps r) else false.
End Run.
