(** * The compliant model: the equations in contact and the equation of the deviation

    In contact, with p = a1 t, the five equations say the same as modelSysDev for the deviation of b with the formulas
    modelSysDevRecoverY, V, Z, LN for the deviations of y, v, z and of the force. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus CompliantMechanism.
Open Scope R_scope.

Section Deviation.
Variables (a1 a2 a3 eps : R) (p b y v z : R -> R).
Hypothesis Ha3 : a3 <> 0.
Hypothesis Ha13 : a1 <> a3.
Hypothesis Heps : 0 < eps.
Hypothesis Hp : forall t, p t = a1 * t.

Let bh (t : R) : R := b t - a2 / (a1 - a3) * a1 * t.

Lemma deviation_forward : (forall t, model_at a1 a2 a3 eps linear_force p b y v z t) ->
  deviation_form a1 a2 a3 eps b y v z.
Proof.
intros H.
destruct (recover_converse a1 a2 a3 eps Ha3 Ha13 Heps p_infty p b y v z (fun t _ => Hp t) (fun t _ => H t))
  as (b0 & b1 & b2 & b3 & (D0 & D1 & D2 & D3) & HR & HB).
assert (E0 : forall t, bh t = b0 t) by (intros t; symmetry; apply HB).
assert (E1 : forall t, Derive bh t = b1 t).
{ intros t. rewrite (Derive_ext bh b0) by auto. apply is_derive_unique, (D0 t I). }
assert (E2 : forall t, Derive_n bh 2 t = b2 t).
{ intros t. simpl. rewrite (Derive_ext _ b1) by auto. apply is_derive_unique, (D1 t I). }
assert (E3 : forall t, Derive_n bh 3 t = b3 t).
{ intros t. change (Derive (Derive_n bh 2) t = b3 t). rewrite (Derive_ext _ b2) by auto.
  apply is_derive_unique, (D2 t I). }
assert (E4 := fun t => is_derive_unique _ _ _ (D3 t I)).
assert (E4' : forall t, Derive_n bh 4 t = (a3 * b0 t - a1 * t * b1 t + eps * ((a3 - a1) * b1 t - a1 * t * b2 t)
  - 2 * eps ^ 2 * b3 t) / eps ^ 3).
{ intros t. change (Derive (Derive_n bh 3) t = (a3 * b0 t - a1 * t * b1 t + eps * ((a3 - a1) * b1 t - a1 * t * b2 t)
    - 2 * eps ^ 2 * b3 t) / eps ^ 3).
  rewrite (Derive_ext _ b3) by auto. apply E4. }
split.
- intros [|[|[|[|[|k]]]]] t Hk; [exact I| | | | |lia]; unfold ex_derive_n; eexists.
  + apply (is_derive_ext b0); [intros; symmetry; apply E0|apply (D0 t I)].
  + apply (is_derive_ext b1); [intros; symmetry; apply E1|apply (D1 t I)].
  + apply (is_derive_ext b2); [intros; symmetry; apply E2|apply (D2 t I)].
  + apply (is_derive_ext b3); [intros; symmetry; apply E3|apply (D3 t I)].
- intros t. destruct (HR t I) as (_ & _ & Ey & Ev & Ez). cbv zeta. fold (bh t). fold bh.
  rewrite E0, E1, E2, E3, E4', Ey, Ev, Ez. unfold linear_force, rec_y, rec_v, rec_z.
  refine (conj _ (conj _ (conj _ (conj _ _)))); field; repeat split; lra.
Qed.

Lemma deviation_backward : deviation_form a1 a2 a3 eps b y v z -> forall t,
  model_at a1 a2 a3 eps linear_force p b y v z t.
Proof.
intros (Hex & H).
assert (D : forall n t, (n < 4)%nat -> is_derive (Derive_n bh n) t (Derive_n bh (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n bh n)). exact (Hex (S n) t Hn). }
assert (Ch : dev_chain p_infty a1 a3 eps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3)).
{ refine (conj (fun t _ => D 0%nat t ltac:(lia)) (conj (fun t _ => D 1%nat t ltac:(lia))
    (conj (fun t _ => D 2%nat t ltac:(lia)) _))).
  intros t _. assert (A := D 3%nat t ltac:(lia)). destruct (H t) as (E & _).
  change (a3 * bh t - a1 * t * Derive bh t + eps * ((a3 - a1) * Derive bh t - a1 * t * Derive_n bh 2 t)
    - 2 * eps ^ 2 * Derive_n bh 3 t - eps ^ 3 * Derive_n bh 4 t = 0) in E.
  apply (is_derive_val _ _ _ _ A). apply Rmult_eq_reg_r with (eps ^ 3); [|apply pow_nonzero; lra].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by (apply pow_nonzero; lra). lra. }
assert (R := recover a1 a2 a3 eps Ha3 Ha13 Heps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3) p_infty Ch).
assert (Ep : forall t, rec_p a1 t = p t) by (intros t; rewrite Hp; reflexivity).
assert (Eb : forall t, rec_b a1 a2 a3 bh t = b t) by (intros t; unfold rec_b, bh; ring).
assert (Ey : forall t, rec_y a1 a2 a3 eps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3) t = y t).
{ intros t. destruct (H t) as (_ & E & _).
  change (a3 * (y t - 2 * (eps ^ 2 * a2 / (a1 - a3)))
    = eps ^ 2 * (a3 * bh t - a1 * t * Derive bh t + 2 * Derive bh t) - eps ^ 3 * Derive_n bh 2 t
      - eps ^ 4 * Derive_n bh 3 t) in E.
  unfold rec_y. rewrite <- E. field. repeat split; (assumption || lra). }
assert (Ev : forall t, rec_v a1 a3 eps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3) t = v t).
{ intros t. destruct (H t) as (_ & _ & E & _).
  change (a3 * v t = - eps * (a3 * bh t - a1 * t * Derive bh t) + 2 * eps ^ 2 * Derive_n bh 2 t
    + eps ^ 3 * Derive_n bh 3 t) in E.
  unfold rec_v. rewrite <- E. field. auto. }
assert (Ez : forall t, rec_z a1 a2 a3 eps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3) t = z t).
{ intros t. destruct (H t) as (_ & _ & _ & E & _).
  change (a3 * (z t - eps ^ 2 * a2 / (a1 - a3))
    = eps ^ 2 * (a3 * bh t - a1 * t * Derive bh t + Derive bh t) - eps ^ 3 * Derive_n bh 2 t
      - eps ^ 4 * Derive_n bh 3 t) in E.
  unfold rec_z. rewrite <- E. field. repeat split; (assumption || lra). }
intros t. destruct (R t I) as (R1 & R2 & R3 & R4 & R5).
rewrite Ey, Ez in R2, R4, R5. rewrite Ev in R3. rewrite Eb, Ep in R4. unfold model_at.
refine (conj _ (conj _ (conj _ (conj _ _)))).
- exact (is_derive_ext _ _ _ _ Ep R1).
- exact (is_derive_ext _ _ _ _ Eb R2).
- exact (is_derive_ext _ _ _ _ Ey R3).
- exact (is_derive_ext _ _ _ _ Ev R4).
- apply (is_derive_ext (fun s => eps * rec_z a1 a2 a3 eps bh (Derive bh) (Derive_n bh 2) (Derive_n bh 3) s));
    [|exact R5].
  intros s. rewrite Ez. reflexivity.
Qed.
End Deviation.

Theorem deviation_recover a1 a2 a3 eps p b y v z : a3 <> 0 -> a1 <> a3 -> 0 < eps -> (forall t, p t = a1 * t) ->
  ((forall t, model_at a1 a2 a3 eps linear_force p b y v z t) <-> deviation_form a1 a2 a3 eps b y v z).
Proof.
intros H3 H13 He Hp. split.
- apply (deviation_forward a1 a2 a3 eps p b y v z H3 H13 He Hp).
- intros H. apply (deviation_backward a1 a2 a3 eps p b y v z H3 H13 He Hp H).
Qed.
