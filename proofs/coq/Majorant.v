(** * A bound of Theta by one with a smaller parameter

    The coefficients a_k of the Taylor series at 0 of Theta(., b) have a_(k+3) = (k - b) a_k/((k+1)(k+2)(k+3)), and |k -
    b| <= k + B for |b| <= B: so |a_k| <= M A_k, with A_k those of Theta(., -B), for every k if for the first three. *)

From Coq Require Import Reals Psatz Lra Lia.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus EntireForm SolutionSeries.
Open Scope R_scope.

Lemma coefficients_below b B M c A : recurrence b 0 c -> recurrence (- B) 0 A -> Rabs b <= B ->
  (forall k, (k < 3)%nat -> Rabs (c k) <= M * A k) -> forall k, Rabs (c k) <= M * A k.
Proof.
intros Hc HA Hb H3.
assert (Next : forall k, Rabs (c k) <= M * A k -> Rabs (c (k + 3)%nat) <= M * A (k + 3)%nat).
{ intros k Hk. assert (P := pos_INR k). assert (Rc := Hc k). assert (RA := HA k).
  set (d := (INR k + 1) * (INR k + 2) * (INR k + 3)) in *.
  assert (Hd : 0 < d) by (unfold d; repeat apply Rmult_lt_0_compat; lra).
  apply Rmult_le_reg_l with d. exact Hd.
  rewrite <- (Rabs_pos_eq d) at 1 by lra. rewrite <- Rabs_mult.
  replace (d * c (k + 3)%nat) with ((INR k - b) * c k) by lra.
  replace (d * (M * A (k + 3)%nat)) with ((INR k + B) * (M * A k)).
  2: { replace (d * (M * A (k + 3)%nat)) with (M * (d * A (k + 3)%nat)) by ring. rewrite RA. ring. }
  rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; auto.
  apply Rabs_le_between in Hb. apply Rabs_le. lra. }
assert (All : forall n k, (k < n)%nat -> Rabs (c k) <= M * A k).
{ induction n as [|n IH]; intros k Hk. lia. destruct (Nat.lt_ge_cases k 3) as [L|L]. auto.
  replace k with (k - 3 + 3)%nat by lia. apply Next, IH. lia. }
intros k. apply (All (S k)). lia.
Qed.

Lemma series_below (a d : nat -> R) x y : is_series a x -> is_series d y -> (forall n, Rabs (a n) <= d n) ->
  Rabs x <= y.
Proof.
intros Ha Hd H. assert (E : ex_series (fun n => Rabs (a n))).
{ apply (ex_series_le (fun n => Rabs (a n)) d). 2: exists y; exact Hd.
  intros n. change (Rabs (Rabs (a n)) <= d n). rewrite Rabs_Rabsolu. apply H. }
rewrite <- (is_series_unique a x Ha), <- (is_series_unique d y Hd).
eapply Rle_trans. apply Series_Rabs, E. apply Series_le. 2: exists y; exact Hd.
intros n. split. apply Rabs_pos. apply H.
Qed.

Theorem majorant b B M X t theta large : is_Theta_entire b theta -> is_Theta_entire (- B) large -> Rabs b <= B ->
  (forall k, (k < 3)%nat -> Rabs (Derive_n theta k 0) <= M * Derive_n large k 0) -> Rabs t <= X ->
  Rabs (theta t) <= M * large X.
Proof.
assert (Series : forall b theta, is_Theta_entire b theta -> exists c, recurrence b 0 c /\ c 0%nat = theta 0 /\
  c 1%nat = Derive theta 0 /\ c 2%nat = Derive_n theta 2 0 / 2 /\ forall t, is_pseries c t (theta t)).
{ intros q f H. destruct (entire_chain q f H) as (D0 & D1 & D2 & _).
  exists (from_values q 0 (f 0) (Derive f 0) (Derive_n f 2 0 / 2)).
  assert (R := from_values_recurrence q 0 (f 0) (Derive f 0) (Derive_n f 2 0 / 2)).
  split; [exact R|]. split; [reflexivity|]. split; [reflexivity|]. split; [reflexivity|]. intros s.
  rewrite <- (Rminus_0_r s) at 1.
  apply (solution_series q 0 _ R f (Derive f) (Derive_n f 2)); [exact (conj D0 (conj D1 D2))|reflexivity|reflexivity|].
  change (2 * (Derive_n f 2 0 / 2) = Derive_n f 2 0). field. }
intros Ht Hl Hb H3 HX.
destruct (Series b theta Ht) as (c & Rc & C0 & C1 & C2 & Sc).
destruct (Series (- B) large Hl) as (A & RA & A0 & A1 & A2 & SA).
assert (Below : forall k, Rabs (c k) <= M * A k).
{ apply (coefficients_below b B M c A Rc RA Hb). intros [|[|[|k]]] Hk; [| | |lia].
  - rewrite C0, A0. apply (H3 0%nat Hk).
  - rewrite C1, A1. apply (H3 1%nat Hk).
  - rewrite C2, A2. assert (H := H3 2%nat Hk). unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra.
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra|exact H]. }
apply (series_below (fun k => c k * t ^ k) (fun k => M * (A k * X ^ k))).
- apply (is_series_ext (fun k => scal (pow_n t k) (c k))); [|exact (Sc t)].
  intros n. rewrite pow_n_pow. apply Rmult_comm.
- assert (Q : is_series (fun k => A k * X ^ k) (large X)).
  { apply (is_series_ext (fun k => scal (pow_n X k) (A k))); [|exact (SA X)].
    intros n. rewrite pow_n_pow. apply Rmult_comm. }
  exact (is_series_scal_l M _ _ Q).
- intros n. rewrite Rabs_mult, <- RPow_abs, <- Rmult_assoc.
  apply Rmult_le_compat; auto using Rabs_pos. apply pow_le, Rabs_pos. apply pow_incr. split; [apply Rabs_pos|exact HX].
Qed.
