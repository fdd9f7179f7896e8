(** * The checker of runs runs

    On the first phase of one file, by Coq's own virtual machine ([vm_compute], part of its kernel); the theorem then
    says what follows. And on runs that are wrong: it must not accept them. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight CompliantMotion Checker RunScene RunChecker RunTheorem
  DataRun StatementRun.
Import ListNotations.
Open Scope R_scope.

(** Before lift-off y < z, which is to say that the contact force is positive. *)
Lemma accepted_run_is_true r g : run_accepted r g = true -> true_run_claim g.
Proof.
intros H. assert (He : 0 < Q2R (eps g)) by exact (accepted_eps r g H). split.
- destruct (CompliantMotion.motion_exists (Q2R (alpha1 g)) (Q2R (alpha2 g)) (Q2R (alpha1 g * beta g)) (Q2R (eps g)) He
    contact_force (contact_lipschitz _ He) 0 (Q2R (p0 g)) (Q2R (b0 g)) (Q2R (y0 g)) (Q2R (v0 g)) (Q2R (z0 g)))
    as (p & b & y & v & z & M & S).
  exists p, b, y, v, z. split; [|exact S]. intros t _. apply M.
- intros p b y v z (M & P & B & Y & V & Z).
  destruct (accepted_run r g p b y v z H M P B Y V Z) as (t1 & T & Between & Contact & Off).
  exists t1. split; [exact T|]. split; [exact Between|]. split; [|exact Off].
  intros t Ht. unfold contact_force. destruct (Rlt_dec (y t) (z t)) as [L|L]; [|contradiction (L (Contact t Ht))].
  apply Rdiv_lt_0_compat; [lra|apply pow_lt, He].
Qed.

(** The kernel computes once, at the end of the proof. *)
Lemma run_fig_varsim1_accepted : run_accepted run_fig_varsim1 run_fig_varsim1_scene = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma Q2R_integer z : Q2R (z # 1) = IZR z.
Proof. unfold Q2R. simpl. field. Qed.

Theorem run_fig_varsim1_checked : StatementRun.run_fig_varsim1_checked.
Proof.
split; [exact run_fig_varsim1_accepted|]. assert (H := accepted_run_is_true _ _ run_fig_varsim1_accepted).
unfold true_run_claim in H. cbn [eps alpha1 alpha2 beta b0 p0 v0 y0 z0 low high run_fig_varsim1_scene] in H.
rewrite !Q2R_integer in H. exact H.
Qed.

(** ** What is not true is not accepted *)
Open Scope Z_scope.

(** The last two steps as a run by itself, from the point where the first of them begins; with other steps, other ends
    of the bracket. *)
Definition at_first : Z :=
  Eval vm_compute in fold_right (fun s n => duration s + n) 0 (firstn 47 (steps run_fig_varsim1)).
Definition last_steps : list step := Eval vm_compute in skipn 47 (steps run_fig_varsim1).
Definition short_rates : rates :=
  Eval vm_compute in let r := its_rates run_fig_varsim1 in let c := clock run_fig_varsim1 in
  Rates (below r * c) (rate1 r * c) (rate2 r * c) (rate3 r * c) (first_p r * c + rate1 r * at_first).
Definition from_tick : Z := Eval vm_compute in left_tick run_fig_varsim1.
Definition to_tick : Z := Eval vm_compute in right_tick run_fig_varsim1.

Definition short (l : list step) (left right : Z) : run := let r := run_fig_varsim1 in
  Run short_rates (clock r) (grain r) (fine r) (scale r) (ticks r) l left right (halvings r) (depth r).
Definition the_run : run := short last_steps from_tick to_tick.
Definition the_scene : scene := Eval vm_compute in
  let g := run_fig_varsim1_scene in let m := first_middle the_run in let e := eps g in
  let value i := (inject_Z (m i) / inject_Z (grain run_fig_varsim1))%Q in
  let past := (e * inject_Z at_first / inject_Z (clock run_fig_varsim1))%Q in
  Scene e (alpha1 g) (alpha2 g) (beta g) (value of_b) (p0 g + alpha1 g * past)%Q (e * value of_v)%Q
    (e * e * value of_y)%Q (e * e * value of_z)%Q (low g - past)%Q (high g - past)%Q.

Definition with_steps (l : list step) : bool := run_accepted (short l from_tick to_tick) the_scene.
Definition with_ticks (left right : Z) : bool := run_accepted (short last_steps left right) the_scene.
Definition no_step : step := Step 0 (row [] [] [] []) [].
Definition first_one : step := Eval vm_compute in nth 0 last_steps no_step.
Definition last_one : step := Eval vm_compute in nth 1 last_steps no_step.

(** The first step with another change of its pieces, of the nodes in them, of its polynomials. *)
Definition with_pieces (change : list piece -> list piece) : bool :=
  with_steps [Step (duration first_one) (curve first_one) (change (pieces first_one)); last_one].
Definition with_piece (change : piece -> piece) : bool := with_pieces (map change).
Definition with_nodes (change : list (vector Z) -> list (vector Z)) : bool := with_piece (fun c =>
  Piece (right_end c) (basis c) (inverse c) (determinant c) (blocks c) (change (nodes c))).
Definition with_curve (change : vector poly -> vector poly) : bool :=
  with_steps [Step (duration first_one) (change (curve first_one)) (pieces first_one); last_one].

Example the_last_two_steps : with_nodes (fun w => w) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Definition lower (w : vector Z) : vector Z := stored (fun i => w i - w i / 2 ^ 22).
Definition no_vector : vector Z := row 0 0 0 0.
Definition all_alike (w : list (vector Z)) : list (vector Z) := map (fun _ => hd no_vector w) w.

Example the_errors_at_the_left_end_for_the_whole_piece : with_nodes all_alike = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example the_errors_at_the_left_end_alone : with_nodes (firstn 1) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example no_errors_at_all : with_nodes (map (fun _ => no_vector)) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example errors_a_little_too_small_at_the_right_end :
  with_nodes (fun w => removelast w ++ [lower (List.last w no_vector)]) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example errors_a_little_too_small_in_the_middle :
  with_nodes (fun w => firstn 30 w ++ map lower (firstn 1 (skipn 30 w)) ++ skipn 31 w) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

(** The first step leaves errors: the second one may not begin with less. *)
Example errors_a_little_too_small_at_the_left_end :
  with_steps [first_one; Step (duration last_one) (curve last_one) (map (fun c =>
    Piece (right_end c) (basis c) (inverse c) (determinant c) (blocks c)
      (map lower (firstn 1 (nodes c)) ++ skipn 1 (nodes c))) (pieces last_one))] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_defect_that_is_left_out :
  with_curve (fun x => row (x of_b) (x of_y) (poly_plus (x of_v) [0; 2 ^ 60]) (x of_z)) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_step_that_does_not_begin_where_the_last_one_ended :
  with_steps [first_one; Step (duration last_one)
    (row (curve last_one of_b) (curve last_one of_y) (poly_plus (curve last_one of_v) [2 ^ 60]) (curve last_one of_z))
    (pieces last_one)] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example another_length_of_the_step :
  with_steps [Step (duration first_one + 1) (curve first_one) (pieces first_one); last_one] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_step_that_is_left_out : with_steps [last_one] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example no_steps : with_steps [] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_step_without_pieces : with_pieces (fun _ => []) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example pieces_up_to_a_time_before_the_end : with_piece (fun c =>
  Piece (right_end c - 1) (basis c) (inverse c) (determinant c) (blocks c) (nodes c)) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_matrix_that_is_not_the_inverse : with_piece (fun c => Piece (right_end c) (basis c)
  (fun i j => inverse c i j + match i, j with of_v, of_v => 1 | _, _ => 0 end) (determinant c) (blocks c) (nodes c))
  = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_basis_that_is_not_regular : with_piece (fun c => Piece (right_end c) (fun _ _ => 0) (inverse c) 0 (blocks c)
  (nodes c)) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_negative_multiple_of_the_inverse : with_piece (fun c => Piece (right_end c) (basis c)
  (fun i j => - inverse c i j) (- determinant c) (blocks c) (nodes c)) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

(** Contact, and its end. *)
Example contact_on_a_step_and_none_on_the_next :
  map (fun s => in_contact the_run s no_vector) [first_one; last_one] = [true; false].
Proof. vm_cast_no_check (eq_refl [true; false]). Qed.

Example errors_larger_than_the_force : in_contact the_run first_one (row 0 (2 ^ 240) 0 0) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example the_last_step_before_lift_off : with_steps [first_one] = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example the_right_end_is_the_left_end : with_ticks from_tick from_tick = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_bracket_before_lift_off : with_ticks from_tick (from_tick + (to_tick - from_tick) / 64) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_bracket_after_lift_off : with_ticks (to_tick - (to_tick - from_tick) / 64) to_tick = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_bracket_from_the_beginning_of_the_step : with_ticks 0 to_tick = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

(** The scene with one number changed; the last two are the ends of the bracket of the claim. *)
Definition scene_with (e a1 a2 b3 b p v y z l h : Q) : bool := let g := the_scene in run_accepted the_run
  (Scene (eps g + e) (alpha1 g + a1) (alpha2 g + a2) (beta g + b3) (b0 g + b) (p0 g + p) (v0 g + v) (y0 g + y)
    (z0 g + z) (low g + l) (high g + h))%Q.
Example the_scene_unchanged : scene_with 0 0 0 0 0 0 0 0 0 0 0 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Example the_equations_changed_a_little : let d := (1 # 10 ^ 40)%Q in
  scene_with d 0 0 0 0 0 0 0 0 0 0 || scene_with 0 d 0 0 0 0 0 0 0 0 0 || scene_with 0 0 d 0 0 0 0 0 0 0 0
  || scene_with 0 0 0 d 0 0 0 0 0 0 0 || scene_with 0 0 0 0 0 d 0 0 0 0 0 = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

(** The start within the bounds of the errors, and not. *)
Definition start_with (d : Q) : list bool := [scene_with 0 0 0 0 d 0 0 0 0 0 0; scene_with 0 0 0 0 0 0 d 0 0 0 0;
  scene_with 0 0 0 0 0 0 0 d 0 0 0; scene_with 0 0 0 0 0 0 0 0 d 0 0].

Example the_start_changed_within_the_errors : start_with (1 # 10 ^ 60) = [true; true; true; true].
Proof. vm_cast_no_check (eq_refl [true; true; true; true]). Qed.

Example the_start_changed_by_more : start_with (1 # 10 ^ 33) = [false; false; false; false].
Proof. vm_cast_no_check (eq_refl [false; false; false; false]). Qed.

Example the_start_changed_by_more_to_the_left : start_with (-1 # 10 ^ 33) = [false; false; false; false].
Proof. vm_cast_no_check (eq_refl [false; false; false; false]). Qed.

Example a_bracket_of_the_claim_that_begins_too_late : scene_with 0 0 0 0 0 0 0 0 0 (1 # 10 ^ 32) 0 = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example a_bracket_of_the_claim_that_ends_too_soon : scene_with 0 0 0 0 0 0 0 0 0 0 (-1 # 10 ^ 32) = false.
Proof. vm_cast_no_check (eq_refl false). Qed.

Example no_positive_eps : scene_with (- eps the_scene)%Q 0 0 0 0 0 0 0 0 0 0 = false.
Proof. vm_cast_no_check (eq_refl false). Qed.
