(** * The compliant model: the force less its mean, and its derivatives

    In contact the deviation w of b from its trivial part, the force less its mean and the functions [force_excess1],
    [force_excess2] of the state are a chain of derivatives, with the equation of the deviation at its end; p need not
    be a1 t. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus.
Open Scope R_scope.

Section Excess.
Variables (a1 a2 a3 eps : R).
Hypothesis Ha13 : a1 <> a3.
Hypothesis Heps : 0 < eps.
Variables p b y v z : R -> R.

Definition deviation (t : R) : R := b t - a2 / (a1 - a3) * p t.
Definition excess (t : R) : R := force_excess a1 a2 a3 eps (y t) (z t).
Definition excess1 (t : R) : R := force_excess1 eps (y t) (v t) (z t).
Definition excess2 (t : R) : R := force_excess2 eps (p t) (b t) (y t) (v t) (z t).

Lemma state_ex force t : model_at a1 a2 a3 eps force p b y v z t -> ex_derive p t /\ ex_derive b t /\ ex_derive y t /\
  ex_derive v t /\ ex_derive z t.
Proof.
intros (Dp & Db & Dy & Dv & Dz).
refine (conj (ex_intro _ _ Dp) (conj (ex_intro _ _ Db) (conj (ex_intro _ _ Dy) (conj (ex_intro _ _ Dv) _)))).
exists (/ eps * (- z t - eps ^ 2 * force eps (y t) (z t))).
apply (is_derive_ext (fun s => / eps * (eps * z s))).
{ intros s. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
apply (is_derive_scal (fun s => eps * z s)), Dz.
Qed.

Lemma in_contact t : model_at a1 a2 a3 eps contact_force p b y v z t -> y t < z t ->
  model_at a1 a2 a3 eps linear_force p b y v z t.
Proof.
intros H Hc. assert (E : contact_force eps (y t) (z t) = linear_force eps (y t) (z t)).
{ unfold contact_force. destruct (Rlt_dec (y t) (z t)); [reflexivity|lra]. }
unfold model_at in *. rewrite E in H. exact H.
Qed.

Lemma excess_derive t : model_at a1 a2 a3 eps linear_force p b y v z t ->
  is_derive deviation t (- a3 * excess t) /\ is_derive excess t (excess1 t) /\ is_derive excess1 t (excess2 t) /\
  is_derive excess2 t ((- deviation t + (- p t + eps * (a3 - a1)) * excess t - p t * eps * excess1 t
    - 2 * eps ^ 2 * excess2 t) / eps ^ 3).
Proof.
intros H. destruct (state_ex _ t H) as (Xp & Xb & Xy & Xv & Xz). destruct H as (Dp & Db & Dy & Dv & Dz).
unfold linear_force in *.
assert (Dz' : is_derive z t ((y t - 2 * z t) / eps)).
{ apply (is_derive_ext (fun s => / eps * (eps * z s))).
  { intros s. match goal with |- ?x = ?y => change (@eq R x y) end. field; lra. }
  replace ((y t - 2 * z t) / eps) with (/ eps * (- z t - eps ^ 2 * ((z t - y t) / eps ^ 2))) by (field; lra).
  apply (is_derive_scal (fun s => eps * z s)), Dz. }
assert (Ep := is_derive_unique _ _ _ Dp). assert (Eb := is_derive_unique _ _ _ Db).
assert (Ey := is_derive_unique _ _ _ Dy).
assert (Ev := is_derive_unique _ _ _ Dv). assert (Ez := is_derive_unique _ _ _ Dz').
refine (conj _ (conj _ (conj _ _)));
  unfold deviation, excess2, excess1, excess, force_excess, force_excess1, force_excess2; auto_derive; repeat split;
    auto;
  change (fun x => y x) with y; change (fun x => z x) with z; change (fun x => v x) with v;
    change (fun x => b x) with b;
  change (fun x => p x) with p; rewrite ?Ep, ?Ey, ?Ez, ?Ev, ?Eb; field; repeat split; lra.
Qed.

End Excess.
