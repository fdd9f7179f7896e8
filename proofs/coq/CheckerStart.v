(** * The checker's start at -x is right

    The models of the terms of the enveloping series hold; what is left out after N terms is theta times the next term,
    0 <= theta <= 1 ([StartOnTheLeft.v]), and 2 theta - 1 is the weight of a place of the model of its own. So one
    choice of weights serves the whole way along t. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate SolutionSeries EntireForm CertificateFamily StartOnTheLeft
  Checker CheckerModels CheckerEnclosure.
Import ListNotations.
Open Scope R_scope.

Section Start.
Variables (g : setting) (b eta : R) (rho : nat -> R).
Hypothesis Heta : Rabs eta <= 1.
Hypothesis Hunit : (0 < b_unit g)%Z.
Hypothesis Hb : IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.
Hypothesis Hrho : weights rho.
Hypothesis Hrho0 : rho 0%nat = 1.
Let holds := CheckerModels.holds eta rho.

Lemma holds_value m y y' : holds m y -> y = y' -> holds m y'.
Proof. intros H <-. exact H. Qed.

Lemma holds_once k term y : holds term y -> holds (once g k term) (y * (3 * IZR k - b)).
Proof.
intros H. assert (U := unit_pos g Hunit). eapply holds_value.
- apply (holds_shrink eta Heta rho Hrho); [exact Hunit|]. apply (holds_minus_b g b eta rho Heta Hb), H.
- rewrite mult_IZR. field. lra.
Qed.

Lemma holds_twice k term y : holds term y -> holds (twice g k term) (y * (3 * IZR k - b) * (3 * IZR k + 1 - b)).
Proof.
intros H. assert (U := unit_pos g Hunit). eapply holds_value.
- apply (holds_shrink eta Heta rho Hrho); [exact Hunit|]. apply (holds_minus_b g b eta rho Heta Hb), holds_once, H.
- rewrite plus_IZR, mult_IZR. field. lra.
Qed.

Lemma holds_next_term x k term y : (0 < x)%Z -> (0 <= k)%Z -> holds term y ->
  holds (next_term g x k term) (- (y * (3 * IZR k - b) * (3 * IZR k + 1 - b) * (3 * IZR k + 2 - b))
    / (3 * (IZR k + 1) * IZR x ^ 3)).
Proof.
intros Hx Hk H. assert (U := unit_pos g Hunit). assert (X : 0 < IZR x) by (apply IZR_lt; auto).
assert (K : 0 <= IZR k) by (apply IZR_le; auto).
eapply holds_value.
- apply holds_times. apply (holds_shrink eta Heta rho Hrho).
  2: { apply (holds_minus_b g b eta rho Heta Hb), holds_twice, H. }
  apply Z.mul_pos_pos; auto. apply Z.mul_pos_pos; [lia|]. apply Z.pow_pos_nonneg; lia.
- replace (x ^ 3)%Z with (x * (x * x))%Z by ring. rewrite !mult_IZR, !plus_IZR, mult_IZR. field. repeat split; lra.
Qed.

(** theta times a term. *)
Lemma holds_rest i term y theta : (i <= 2)%nat -> 0 <= theta <= 1 -> rho (S i) = 2 * theta - 1 -> holds term y ->
  holds (rest_at i g term) (theta * y).
Proof.
intros Hi Ht Hr H. assert (S := holds_shrink eta Heta rho Hrho (kept_degrees g) 2 term y eq_refl H).
unfold rest_at. set (half := shrink (kept_degrees g) 2 term) in *. set (own := hd [] (parts half)).
assert (Own : Rabs (y / 2 - value eta own) <= IZR (error half + parts_norm (tl (parts half)))).
{ unfold CheckerModels.holds in S. rewrite plus_IZR. unfold own. destruct (parts half) as [|a p].
  - cbn [hd tl combined] in *. change (value eta []) with 0. change (IZR (parts_norm [])) with 0. lra.
  - cbn [hd tl combined] in *. rewrite Hrho0 in S.
    assert (C := combined_norm eta Heta p _ (weights_tail _ Hrho)).
    replace (y / 2 - value eta a) with ((y / 2 - (1 * value eta a + combined eta (fun i => rho (Datatypes.S i)) p))
      + combined eta (fun i => rho (Datatypes.S i)) p) by ring.
    apply Rabs_plus_le; auto. }
unfold holds, CheckerModels.holds. cbn [parts error].
assert (V : combined eta rho (own :: repeat [] i ++ [own]) = value eta own + (2 * theta - 1) * value eta own).
{ rewrite <- Hr. cbn [combined]. rewrite Hrho0. destruct i as [|[|[|i]]]; try lia; simpl; ring. }
rewrite V, mult_IZR.
replace (theta * y - (value eta own + (2 * theta - 1) * value eta own)) with (2 * theta * (y / 2 - value eta own))
  by field.
rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. rewrite Rabs_pos_eq; lra.
Qed.

Section Sums.
Variables (x : Z) (w : R).
Hypothesis Hx : (0 < x)%Z.
Let st := start_term b (IZR x).

Lemma terms_hold : forall count k term s0 s1 s2 term' s0' s1' s2',
  holds term (w * st k) -> holds s0 (w * sum_first st k) ->
  holds s1 (w * sum_first (fun k => st k * (3 * INR k - b)) k) ->
  holds s2 (w * sum_first (fun k => st k * (3 * INR k - b) * (3 * INR k + 1 - b)) k) ->
  terms count g x (Z.of_nat k) term s0 s1 s2 = (term', s0', s1', s2') ->
  holds term' (w * st (k + count)%nat) /\ holds s0' (w * sum_first st (k + count)) /\
  holds s1' (w * sum_first (fun k => st k * (3 * INR k - b)) (k + count)) /\
  holds s2' (w * sum_first (fun k => st k * (3 * INR k - b) * (3 * INR k + 1 - b)) (k + count)).
Proof.
induction count as [|count IH]; intros k term s0 s1 s2 term' s0' s1' s2' H0 H1 H2 H3 E; cbn [terms] in E.
- injection E as <- <- <- <-. rewrite Nat.add_0_r. auto.
- replace (Z.of_nat k + 1)%Z with (Z.of_nat (S k)) in E by lia. replace (k + S count)%nat with (S k + count)%nat by lia.
  assert (Ek : IZR (Z.of_nat k) = INR k) by (symmetry; apply INR_IZR_INZ).
  apply IH in E; auto.
  + eapply holds_value. apply holds_next_term; [exact Hx|lia|exact H0]. rewrite Ek. unfold st.
    rewrite start_term_step by (apply IZR_lt; auto).
    assert (P := pos_INR k). field. split; [apply Rgt_not_eq, IZR_lt; auto|lra].
  + eapply holds_value. apply holds_plus; [exact H1|exact H0]. simpl. ring.
  + eapply holds_value. apply holds_plus; [exact H2|apply holds_once, H0]. rewrite Ek. simpl. ring.
  + eapply holds_value. apply holds_plus; [exact H3|apply holds_twice, H0]. rewrite Ek. simpl. ring.
Qed.
End Sums.

End Start.

(** ** The start *)
Section Whole.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.
Variables (g : setting) (b eta : R).
Hypothesis Heta : Rabs eta <= 1.
Hypothesis Hunit : (0 < b_unit g)%Z.
Hypothesis Hb : IZR (b_unit g) * b = IZR (b_centre g) + IZR (b_radius g) * eta.

(** F in units. *)
Definition factor (one x : Z) : R := IZR one / Rpower (IZR x) b.

Lemma family_solves w : solves b (fun t => w * F b t) (fun t => w * Derive (F b) t) (fun t => w * Derive_n (F b) 2 t).
Proof. destruct (entire_chain b (F b) (HF b)) as (D0 & D1 & D2 & _). apply solves_scal. split; [|split]; auto. Qed.

Theorem start_right count x one : (0 < x)%Z -> (0 < one)%Z -> b < 3 * INR count ->
  0 < factor one x /\ exists rho, weights rho /\ rho 0%nat = 1 /\
  state_holds eta rho (fun t => factor one x * F b t) (fun t => factor one x * Derive (F b) t) (fun t =>
    factor one x * Derive_n (F b) 2 t)
    (start count g x one).
Proof.
intros Hx H1 HN. assert (X : 0 < IZR x) by (apply IZR_lt; auto). assert (P : 0 < Rpower (IZR x) b) by apply exp_pos.
split. { apply Rdiv_lt_0_compat; auto. apply IZR_lt; auto. }
destruct (value_at_start F HF (IZR x) count X b HN) as (h0 & T0 & V0).
destruct (slope_at_start F HF (IZR x) count X b HN) as (h1 & T1 & V1).
destruct (second_at_start F HF (IZR x) count X b HN) as (h2 & T2 & V2).
set (rho := fun i : nat => match i with 0%nat => 1 | 1%nat => 2 * h0 - 1 | 2%nat => 2 * h1 - 1 | 3%nat => 2 * h2 - 1 |
  _ => 0 end).
assert (Hrho : weights rho).
{ intros [|[|[|[|i]]]]; simpl; apply Rabs_le; lra. }
exists rho. split; auto. split; [reflexivity|].
unfold start. destruct (terms count g x 0 (Model [[one]] 0) zero_model zero_model zero_model) as [[[term s0] s1] s2]
  eqn:E.
assert (Z0 : forall v : nat -> R, CheckerModels.holds eta rho zero_model (IZR one * sum_first v 0)).
{ intros v. simpl. rewrite Rmult_0_r. apply holds_zero. }
destruct (terms_hold g b eta rho Heta Hunit Hb Hrho x (IZR one) Hx count 0 (Model [[one]] 0)
  zero_model zero_model zero_model term s0 s1 s2)
  as (K & K0 & K1 & K2); auto.
{ unfold CheckerModels.holds. cbn [parts error combined value]. unfold start_term, rho. simpl.
  match goal with |- Rabs ?y <= _ => replace y with 0 by field end. rewrite Rabs_R0. lra. }
cbn [Nat.add] in K, K0, K1, K2. cbv zeta. unfold state_holds. cbn [point scale value0 value1 value2].
rewrite !Q2R_whole, opp_IZR. split; auto.
assert (EN : IZR (Z.of_nat count) = INR count) by (symmetry; apply INR_IZR_INZ).
split; [|split].
- eapply holds_value. apply holds_plus; [exact K0|].
  eapply (holds_rest g eta rho Heta Hrho eq_refl 0); [lia|exact T0|reflexivity|exact K].
  unfold factor. replace (IZR one / Rpower (IZR x) b * F b (- IZR x))
    with (IZR one * (F b (- IZR x) / Rpower (IZR x) b)) by (field; lra). rewrite V0. ring.
- eapply holds_value. apply holds_plus; [exact K1|].
  eapply (holds_rest g eta rho Heta Hrho eq_refl 1); [lia|exact T1|reflexivity|].
  apply (holds_once g b eta rho Heta Hunit Hb Hrho), K.
  rewrite EN. unfold factor.
  replace (IZR x * (IZR one / Rpower (IZR x) b * Derive (F b) (- IZR x)))
    with (IZR one * (IZR x * Derive (F b) (- IZR x) / Rpower (IZR x) b)) by (field; lra).
  rewrite V1. ring.
- eapply holds_value. apply holds_plus; [exact K2|].
  eapply (holds_rest g eta rho Heta Hrho eq_refl 2); [lia|exact T2|reflexivity|].
  apply (holds_twice g b eta rho Heta Hunit Hb Hrho), K.
  rewrite EN. unfold factor.
  replace (IZR x ^ 2 * (IZR one / Rpower (IZR x) b * Derive_n (F b) 2 (- IZR x)))
    with (IZR one * (IZR x ^ 2 * Derive_n (F b) 2 (- IZR x) / Rpower (IZR x) b)) by (field; lra).
  rewrite V2. ring.
Qed.

End Whole.
