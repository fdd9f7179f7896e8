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
