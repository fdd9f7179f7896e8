(** * What is proved about a validated step of an ordinary differential equation: definitions and statements

    This file holds no proof; [Theorems.v] proves each statement under its name. The page is proofs/validated_step.md,
    sections 3 and 5. A vector is a number for each member of a finite type I, and the list [all] holds its members. A
    vector field f gives for each i the component f_i, a function of the whole vector. *)

From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition total {I : Type} (all : list I) (g : I -> R) : R := fold_right (fun i sum => g i + sum) 0 all.

Definition in_box {I : Type} (low high v : I -> R) : Prop := forall i, low i <= v i <= high i.

(** |v|_w <= c, the largest |v_i|/w_i; the weights w are positive. *)
Definition norm_at_most {I : Type} (w v : I -> R) (c : R) : Prop := forall i, Rabs (v i) <= c * w i.

(** mu_w(A) <= mu: in each row the diagonal entry, with its sign, and the sizes of the others. *)
Definition logarithmic_norm_at_most {I : Type} (all : list I) (w : I -> R) (A : I -> I -> R) (mu : R) : Prop :=
  forall i, A i i - Rabs (A i i) + total all (fun j => Rabs (A i j) * (w j / w i)) <= mu.

(** J is the matrix of the partial derivatives of f, which is differentiable in each direction at each point of the
    box. *)
Definition jacobian_on {I : Type} (all : list I) (f : I -> (I -> R) -> R) (J : I -> I -> (I -> R) -> R)
    (low high : I -> R) : Prop :=
  forall v, in_box low high v -> forall i (d : I -> R),
    is_derive (fun s => f i (fun j => v j + s * d j)) 0 (total all (fun j => J i j v * d j)).

(** phi is differentiable at v (in the sense of Frechet) with the gradient d. *)
Definition gradient_at {I : Type} (all : list I) (phi : (I -> R) -> R) (d v : I -> R) : Prop :=
  forall eps, 0 < eps -> exists near, 0 < near /\ forall v', (forall j, Rabs (v' j - v j) <= near) ->
    Rabs (phi v' - phi v - total all (fun j => d j * (v' j - v j))) <= eps * total all (fun j => Rabs (v' j - v j)).

(** L_F phi, the derivative of phi along the field F; d holds the partial derivatives of phi. *)
Definition along {I : Type} (all : list I) (d F : I -> (I -> R) -> R) (v : I -> R) : R :=
  total all (fun j => d j v * F j v).

(** Time runs from 0 to 1 in a step of length h: xi' = h f(xi) from 0 to T. *)
Definition solves {I : Type} (f : I -> (I -> R) -> R) (h : R) (xi : I -> R -> R) (T : R) : Prop :=
  forall i t, 0 <= t <= T -> is_derive (xi i) t (h * f i (fun j => xi j t)).

(** Theorem V1: what is checked of a step. x is the approximation, x' its derivative, delta bounds its defect; the box
    holds all that is closer than [radius] to it; J is bounded there, its logarithmic norm by mu; r is the radius of the
    tube for starts within e0 of x(0). *)
Record step_checked {I : Type} (all : list I) (f : I -> (I -> R) -> R) (J : I -> I -> (I -> R) -> R)
    (low high w : I -> R) (x x' : I -> R -> R) (h mu delta e0 radius r : R) : Prop := StepChecked {
  positive_weights : forall i, 0 < w i;
  positive_length : 0 < h;
  derivatives : jacobian_on all f J low high;
  bounded : exists M, forall v, in_box low high v -> forall i j, Rabs (J i j v) <= M;
  growth : forall v, in_box low high v -> logarithmic_norm_at_most all w (fun i j => J i j v) mu;
  approximation : forall i t, 0 <= t <= 1 -> is_derive (x i) t (x' i t);
  defect : forall t, 0 <= t <= 1 -> norm_at_most w (fun i => h * f i (fun j => x j t) - x' i t) delta;
  inside : forall t, 0 <= t <= 1 -> forall v, norm_at_most w (fun i => v i - x i t) radius -> in_box low high v;
  tube : r = exp (Rmax (h * mu) 0) * (e0 + delta);
  narrow : r < radius
}.

(** The solution from each such start exists, is the only one, and stays in the tube. *)
Definition validated_step : Prop := forall (I : Type) (all : list I) f J (low high w : I -> R) (x x' : I -> R -> R)
  h mu delta e0 radius r,
  (forall i, In i all) -> step_checked all f J low high w x x' h mu delta e0 radius r ->
  forall start : I -> R, norm_at_most w (fun i => start i - x i 0) e0 ->
  exists xi : I -> R -> R, (forall i, xi i 0 = start i) /\ solves f h xi 1 /\
    (forall t, 0 <= t <= 1 -> norm_at_most w (fun i => xi i t - x i t) r) /\
    forall T other, 0 <= T <= 1 -> (forall i, other i 0 = start i) -> solves f h other T ->
      forall i t, 0 <= t <= T -> other i t = xi i t.

(** Theorems V2 and V3: all starts within [spread] of x(0), and the solution from x(0) itself. Yh(t) is a matrix with
    Yh(0) = 1, Yh' its derivative; on the tube J differs from its value on x by at most c; column j of the equation of
    Yh holds up to w_i bound_j. *)
Record set_checked {I : Type} (all : list I) (J : I -> I -> (I -> R) -> R) (w : I -> R) (x : I -> R -> R) (h r : R)
    (Yh Yh' : I -> I -> R -> R) (c : I -> I -> R) (bound : I -> R) : Prop := SetChecked {
  start_is_one : forall i (e : I -> R), total all (fun j => Yh i j 0 * e j) = e i;
  matrix_derivative : forall i j t, 0 <= t <= 1 -> is_derive (Yh i j) t (Yh' i j t);
  jacobian_near : forall t, 0 <= t <= 1 -> forall v, norm_at_most w (fun i => v i - x i t) r ->
    forall i k, Rabs (J i k v - J i k (fun l => x l t)) <= c i k;
  matrix_defect : forall t, 0 <= t <= 1 -> forall i j,
    Rabs (total all (fun k => h * J i k (fun l => x l t) * Yh k j t) - Yh' i j t)
      + h * total all (fun k => c i k * Rabs (Yh k j t)) <= bound j * w i
}.

(** At the end the difference of two solutions is that of their starts times a matrix that is near Yh(1). *)
Definition validated_set : Prop := forall (I : Type) (all : list I) f J (low high w : I -> R) (x x' : I -> R -> R)
  h mu delta spread radius r Yh Yh' c bound,
  (forall i, In i all) -> step_checked all f J low high w x x' h mu delta spread radius r ->
  set_checked all J w x h r Yh Yh' c bound ->
  forall xi zeta : I -> R -> R, solves f h xi 1 -> solves f h zeta 1 ->
  norm_at_most w (fun i => xi i 0 - x i 0) spread -> (forall i, zeta i 0 = x i 0) ->
  exists A : I -> I -> R,
    (forall i j, Rabs (A i j - Yh i j 1) <= w i * exp (Rmax (h * mu) 0) * bound j) /\
    forall i, xi i 1 = zeta i 1 + total all (fun j => A i j * (xi j 0 - x j 0)).

(** ** Events: Theorems V5 and V6

    What holds for one solution of the set, in its own time: where a sign is certain for the set it holds for each
    solution, and the lengths of the steps are numbers for each. *)

(** The state at t. *)
Definition state {I : Type} (xi : I -> R -> R) (t : R) : I -> R := fun i => xi i t.

(** A piece of a run: the box that holds the states on it. *)
Record piece (I : Type) : Type := Piece { low_on : I -> R; high_on : I -> R }.

Definition on_piece {I : Type} (one : piece I) (v : I -> R) : Prop := in_box (low_on I one) (high_on I one) v.

(** The pieces follow one another from t to m, none left out. *)
Fixpoint covers {I : Type} (xi : I -> R -> R) (t : R) (run : list (piece I)) (m : R) : Prop :=
  match run with
  | nil => t = m
  | one :: rest => exists next, t < next /\ (forall s, t <= s <= next -> on_piece one (state xi s)) /\
      covers xi next rest m
  end.

Definition negative {I : Type} (g : (I -> R) -> R) (one : piece I) : Prop := forall v, on_piece one v -> g v < 0.
Definition rising {I : Type} (g' : (I -> R) -> R) (one : piece I) : Prop := forall v, on_piece one v -> 0 < g' v.

Definition every {I : Type} (run : list (piece I)) (Q : piece I -> Prop) : Prop := forall one, In one run -> Q one.

(** xi moves as f says from t0 to m; along it g has the gradient d. *)
Definition moves_with {I : Type} (all : list I) (f : I -> (I -> R) -> R) (g : (I -> R) -> R) (d : I -> (I -> R) -> R)
    (xi : I -> R -> R) (t0 m : R) : Prop := forall s, t0 <= s <= m ->
  (forall i, is_derive (xi i) s (f i (state xi s))) /\ gradient_at all g (fun j => d j (state xi s)) (state xi s).

(** From t0 to m all pieces are negative or rising, and g < 0 at t0. (So each row of rising pieces begins with g < 0: at
    t0, or at the end of a negative piece.) *)
Definition followed {I : Type} (all : list I) (f : I -> (I -> R) -> R) (g : (I -> R) -> R) (d : I -> (I -> R) -> R)
    (xi : I -> R -> R) (t0 : R) (run : list (piece I)) (m : R) : Prop :=
  covers xi t0 run m /\ every run (fun one => negative g one \/ rising (along all d f) one) /\ g (state xi t0) < 0.

(** Theorem V5 (a): g < 0 at m, so g has no zero up to m. *)
Definition no_event : Prop := forall (I : Type) (all : list I) f g d xi t0 m run, (forall i : I, In i all) ->
  moves_with all f g d xi t0 m -> followed all f g d xi t0 run m -> g (state xi m) < 0 ->
  forall s, t0 <= s <= m -> g (state xi s) < 0.

(** Theorem V5 (b): up to m0 as before, with g < 0 there; from m0 to m all pieces are rising, with g > 0 at m. *)
Definition crossing {I : Type} (all : list I) (f : I -> (I -> R) -> R) (g : (I -> R) -> R) (d : I -> (I -> R) -> R)
    (xi : I -> R -> R) (t0 : R) (before : list (piece I)) (m0 : R) (stretch : list (piece I)) (m : R) : Prop :=
  followed all f g d xi t0 before m0 /\ g (state xi m0) < 0 /\ covers xi m0 stretch m /\
  every stretch (rising (along all d f)) /\ 0 < g (state xi m).

(** g has exactly one zero up to m. It lies between m0 and m, g < 0 before it, g > 0 after it, and g' > 0 there. From m0
    to m the states are in each box that holds those of all pieces between, and g' is between bounds of it on them. *)
Definition one_event : Prop := forall (I : Type) (all : list I) f g d xi t0 before m0 stretch m,
  (forall i : I, In i all) -> moves_with all f g d xi t0 m -> crossing all f g d xi t0 before m0 stretch m ->
  exists zero, m0 < zero < m /\ g (state xi zero) = 0 /\ 0 < along all d f (state xi zero) /\
    (forall s, t0 <= s < zero -> g (state xi s) < 0) /\ (forall s, zero < s <= m -> 0 < g (state xi s)) /\
    (forall low high, every stretch (fun one => forall v, on_piece one v -> in_box low high v) ->
      forall s, m0 <= s <= m -> in_box low high (state xi s)) /\
    (forall low high, every stretch (fun one => forall v, on_piece one v -> low <= along all d f v <= high) ->
      forall s, m0 <= s <= m -> low <= along all d f (state xi s) <= high).

(** Theorem V6: of several functions, each with pieces of its own, g k with k = one crosses 0 up to m; each other one is
    followed up to m and < 0 there. Then g one is the first to vanish, and the only one up to its zero (and to m). *)
Definition first_event : Prop := forall (I K : Type) (all : list I) f (g : K -> (I -> R) -> R) d xi t0 before m0
  stretch m (one : K) (run : K -> list (piece I)), (forall i : I, In i all) ->
  (forall k, moves_with all f (g k) (d k) xi t0 m) -> crossing all f (g one) (d one) xi t0 before m0 stretch m ->
  (forall k, k <> one -> followed all f (g k) (d k) xi t0 (run k) m /\ g k (state xi m) < 0) ->
  exists zero, m0 < zero < m /\ g one (state xi zero) = 0 /\
    (forall s, t0 <= s < zero -> g one (state xi s) < 0) /\
    forall k, k <> one -> forall s, t0 <= s <= m -> g k (state xi s) < 0.
