(** * Examples that satisfy all hypotheses of Theorems A1, A4, A6, V5 and V6

    So that no hypothesis is empty: the model system with alpha1 = alpha2 = -1 and alpha3 = - c, c = 1/2 (A1, A4) and
    3/2 (A1, A6; its distinguished trajectory is lambda = 2); the motion x' = 1 with two functions of x, of which one
    crosses 0 (V5 and V6). *)

From Coq Require Import Reals Psatz Lra List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import LogarithmicNorm SmoothFunctions StatementStep StatementApproach.
Import ListNotations.
Open Scope R_scope.

Section Linear.
Variables (I : Type) (all : list I).

Definition linear (c : I -> R) (k : R) (v : I -> R) : R := total all (fun j => c j * v j) + k.

Lemma linear_gradient c k v : gradient_at all (linear c k) c v.
Proof.
intros eps He. exists 1. split; [lra|]. intros v' _. unfold linear.
replace (total all (fun j => c j * v' j) + k - (total all (fun j => c j * v j) + k)
  - total all (fun j => c j * (v' j - v j))) with 0.
- rewrite Rabs_R0. apply Rmult_le_pos; [lra|]. apply total_nonneg. intros. apply Rabs_pos.
- rewrite (total_ext all (fun j => c j * (v' j - v j)) (fun j => c j * v' j - c j * v j)) by (intros; ring).
  rewrite total_minus. ring.
Qed.

Lemma linear_smooth c k low high : (forall j, Rabs (c j) <= 1) -> smooth_on all (linear c k) (fun j _ => c j) low high.
Proof. intros H. split. intros v _. apply linear_gradient. exists 1. intros v _. exact H. Qed.

End Linear.

(** ** The model system *)

Inductive coordinate := Cp | Cb | Cy | Cv.
Definition coordinates : list coordinate := [Cp; Cb; Cy; Cv].
Definition unit_of (i j : coordinate) : R :=
  match i, j with Cp, Cp | Cb, Cb | Cy, Cy | Cv, Cv => 1 | _, _ => 0 end.
Definition drift_part (i j : coordinate) : R := match i with Cy => unit_of Cv j | Cv => unit_of Cb j | _ => 0 end.
Definition contact_part (i j : coordinate) : R := match i with Cv => unit_of Cp j | _ => 0 end.
Definition drift_constant (i : coordinate) : R := match i with Cp | Cb => -1 | _ => 0 end.
Definition contact_constant (c : R) (i : coordinate) : R := match i with Cb => c | _ => 0 end.

Definition model_F i := linear coordinate coordinates (drift_part i) (drift_constant i).
Definition model_G c i := linear coordinate coordinates (contact_part i) (contact_constant c i).
Definition model_start (i : coordinate) : R := match i with Cp => 1 / 10 | Cb => -1 / 10 | _ => 0 end.
Definition coordinate_of (i : coordinate) := linear coordinate coordinates (unit_of i) 0.

Lemma parts_small i j : Rabs (unit_of i j) <= 1 /\ Rabs (drift_part i j) <= 1 /\ Rabs (contact_part i j) <= 1.
Proof. destruct i, j; simpl; rewrite ?Rabs_R0, ?Rabs_R1; lra. Qed.

Lemma coordinates_all i : In i coordinates.
Proof. destruct i; simpl; tauto. Qed.

Example the_model_has_slip_functions c : slip_functions coordinates model_F (model_G c) (fun i j _ => drift_part i j)
  (fun i j _ => contact_part i j) (coordinate_of Cp) (coordinate_of Cb)
  (fun j _ => unit_of Cp j) (fun j _ => unit_of Cb j)
  (fun _ => -1) (fun _ => -1) (fun _ => - c) (fun _ => -1) (fun _ => 1).
Proof.
constructor; try (intros i; apply linear_smooth; intros j; apply parts_small);
  try (apply linear_smooth; intros j; apply parts_small).
- exists 1. intros _ _. rewrite Rabs_left; lra.
- intros xi _; unfold along, model_F, model_G, coordinate_of, linear; simpl. lra.
- intros xi _; unfold along, model_F, model_G, coordinate_of, linear; simpl. lra.
Qed.

Example the_model_has_contact_functions c : contact_functions coordinates model_F (model_G c)
  (fun i j _ => drift_part i j) (fun i j _ => contact_part i j)
  (coordinate_of Cy) (coordinate_of Cv) (coordinate_of Cp) (coordinate_of Cb)
  (fun j _ => unit_of Cy j) (fun j _ => unit_of Cv j) (fun j _ => unit_of Cp j) (fun j _ => unit_of Cb j)
  (fun _ => -1) (fun _ => -1) (fun _ => - c) (fun _ => -1) (fun _ => 1).
Proof.
constructor; [exact (the_model_has_slip_functions c)| | | |];
  try (apply linear_smooth; intros j; apply parts_small);
  intros xi _; unfold along, model_F, model_G, coordinate_of, linear; simpl; repeat split; lra.
Qed.

Example the_model_has_a_neighbourhood c : c = 1 / 2 \/ c = 3 / 2 -> neighbourhood_checked model_F (model_G c)
  (fun _ => -1) (fun _ => -1) (fun _ => - c) model_start model_start (fun _ => -1) (fun _ => 1) 1 c 1 (1 / 10) (1 / 10)
  (fun _ => 1) (fun _ => 3 / 2).
Proof.
intros Hc. assert (c0 : 0 < c <= 3 / 2) by lra. constructor; try lra.
- intros i. lra.
- intros xi Hxi. rewrite (Rabs_left (-1)) by lra. repeat (split; [lra|]).
  intros i. assert (B := Hxi). unfold in_box in B.
  assert (B1 := B Cp). assert (B2 := B Cb). assert (B3 := B Cy). assert (B4 := B Cv).
  unfold model_F, model_G, linear; destruct i; simpl; split; apply Rabs_le; lra.
- intros i. unfold reach. rewrite Rabs_pos_eq by lra. destruct Hc as [-> | ->], i; simpl; split; lra.
Qed.

Example the_model_starts_in_slip c : in_box model_start model_start model_start /\ coordinate_of Cy model_start = 0 /\
  coordinate_of Cv model_start = 0 /\ 0 < coordinate_of Cp model_start <= 1 / 10 /\
  - (1 / 10) <= coordinate_of Cb model_start < 0 /\
  force_stays_positive (fun _ => -1) (fun _ => -1) (fun _ => - c) (fun _ : coordinate => -1) (fun _ => 1)
    (- coordinate_of Cb model_start / coordinate_of Cp model_start).
Proof.
split. { intros i. lra. }
refine (conj _ (conj _ (conj _ (conj _ (or_introl _))))); try (intros i _; lra);
  unfold coordinate_of, linear; simpl; lra.
Qed.

Lemma constant_smooth k low high : smooth_on coordinates (fun _ => k) (fun _ _ => 0) low high.
Proof.
split.
- intros v _ eps He. exists 1. split; [lra|]. intros v' _. rewrite (total_ext coordinates _ (fun _ => 0)), total_zero
    by (intros; ring). replace (k - k - 0) with 0 by ring. rewrite Rabs_R0.
  apply Rmult_le_pos; [lra|]. apply total_nonneg. intros. apply Rabs_pos.
- exists 0. intros v _ j. rewrite Rabs_R0. lra.
Qed.

(** beta = 3/2: lambda = 1 at the start, below 2: sigma = -1, so C1 > 0. *)
Example the_model_has_a_side : side_checked coordinates model_F (model_G (3 / 2)) (fun _ => -1) (fun _ => -1)
  (fun _ => - (3 / 2)) (fun _ _ => 0) (fun _ _ => 0) (fun _ _ => 0) (fun _ => -1) (fun _ => 1) model_start
  (coordinate_of Cp) (coordinate_of Cb) (1 / 2) 1 2 0 (-1).
Proof.
constructor; try apply constant_smooth; try lra.
- exact (constant_smooth (-1 / (- (3 / 2) - -1)) (fun _ => -1) (fun _ => 1)).
- intros xi _. unfold mean_force. replace (-1 / (- (3 / 2) - -1)) with 2 by field. lra.
- intros xi lambda _ _. unfold along, total; simpl.
  match goal with |- Rabs ?t <= _ => replace t with 0 by ring end. rewrite Rabs_R0. lra.
- unfold coordinate_of, linear; simpl. lra.
- unfold coordinate_of, linear, mean_force; simpl. replace (-1 / (- (3 / 2) - -1)) with 2 by field. lra.
Qed.

Example the_model_has_a_distinguished_trajectory : distinguished model_F (model_G (3 / 2)) (fun _ => -1) (fun _ => -1)
  (fun _ => - (3 / 2)) (fun _ => 0) 1 (fun i p => match i with Cp => p | Cb => -2 * p | _ => 0 end) (fun _ => 2).
Proof.
constructor; try lra.
- intros i. destruct i; lra.
- intros p _ i. unfold model_F, model_G, linear, state; simpl. destruct i; auto_derive; auto; simpl; field.
- intros p _. exists 0. split; [apply (is_derive_const 2)|field].
Qed.

(** beta = 1/2: the conditions for C1 < 0, with d = 1/2 and A = 0. *)
Example the_model_has_a_negative_side :
  (forall xi : coordinate -> R, in_box (fun _ => -1) (fun _ => 1) xi -> 1 / 2 <= - (1 / 2) - -1 /\ -1 <= 0) /\
  0 < 1 / 2 * (- coordinate_of Cb model_start / coordinate_of Cp model_start).
Proof. unfold coordinate_of, linear; simpl. split; [intros|]; lra. Qed.

(** ** Events of x' = 1, x(0) = -1/2: x itself, and x - 2 *)

Definition line (_ : unit) (t : R) : R := t - 1 / 2.
Definition box_of (low high : R) : piece unit := Piece unit (fun _ => low) (fun _ => high).
Definition one_or_other (k : bool) := linear unit [tt] (fun _ => 1) (if k then 0 else -2).

Example the_line_moves k : moves_with [tt] (fun _ _ => 1) (one_or_other k) (fun _ _ => 1) line 0 1.
Proof.
intros s _. split. { intros i. unfold line. auto_derive; auto. }
apply linear_gradient.
Qed.

Example the_line_crosses : crossing [tt] (fun _ _ => 1) (one_or_other true) (fun _ _ => 1) line 0
  [box_of (-1 / 2) (-1 / 4)] (1 / 4) [box_of (-1 / 4) (1 / 2)] 1.
Proof.
repeat split.
- simpl. exists (1 / 4). split; [lra|]. split; [|reflexivity]. intros s Hs i. unfold state, line, box_of; simpl. lra.
- intros one [<-|[]]. left. intros v Hv. specialize (Hv tt). unfold one_or_other, linear. simpl in *. lra.
- unfold one_or_other, linear, state, line. simpl. lra.
- unfold one_or_other, linear, state, line. simpl. lra.
- simpl. exists 1. split; [lra|]. split; [|reflexivity]. intros s Hs i. unfold state, line, box_of; simpl. lra.
- intros one [<-|[]] v _. unfold along; simpl. lra.
- unfold one_or_other, linear, state, line. simpl. lra.
Qed.

Example the_other_is_followed : followed [tt] (fun _ _ => 1) (one_or_other false) (fun _ _ => 1) line 0
  [box_of (-1 / 2) (1 / 2)] 1 /\ one_or_other false (state line 1) < 0.
Proof.
repeat split.
- simpl. exists 1. split; [lra|]. split; [|reflexivity]. intros s Hs i. unfold state, line, box_of; simpl. lra.
- intros one [<-|[]]. left. intros v Hv. specialize (Hv tt). unfold one_or_other, linear. simpl in *. lra.
- unfold one_or_other, linear, state, line. simpl. lra.
- unfold one_or_other, linear, state, line. simpl. lra.
Qed.
