(** * A run up to its first lift-off

    The steps of [RunSound.v] one after the other, and the lift-off in the last of them. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import CompliantMotion Checker CheckerModels Calculus StatementStep LogarithmicNorm BlockGrowth
  RunScene RunChecker RunArithmetic RunSound.
Import ListNotations.
Open Scope R_scope.

Section Run.
Variables (r : run) (g : scene).
Hypothesis Hclock : (0 < clock r)%Z.
Hypothesis Hgrain : (0 < grain r)%Z.
Hypothesis Hfine : (0 < fine r)%Z.
Hypothesis Hscale : (0 < scale r)%Z.
Hypothesis Hbelow : (0 < below (its_rates r))%Z.
Hypothesis Heps : 0 < Q2R (eps g).
Let ct := IZR (clock r).
Let gr := IZR (grain r).
Let un := IZR (unit r).

(** b, Y, V, Z as functions of T = t/eps, with the linear law of force. *)
Variable W : coordinate -> R -> R.
Definition p_of (T : R) : R :=
  (IZR (first_p (its_rates r)) + IZR (rate1 (its_rates r)) * T) / IZR (below (its_rates r)).
Hypothesis HW : forall i T,
  is_derive (W i) T (total coordinates (fun l => equations r (p_of T) i l * W l T) + forcing r i).

Section Step.
Variables (begin : Z) (s : step).
Let h := IZR (duration s).
Definition moment (tau : R) : R := (IZR begin + h * tau) / ct.
Definition U (i : coordinate) (tau : R) : R := W i (moment tau).

Lemma U_derive i tau : is_derive (U i) tau
  (h / ct * (total coordinates (fun l => equations r (p_at r begin s tau) i l * U l tau) + forcing r i)).
Proof.
assert (C : 0 < ct) by (apply IZR_lt, Hclock). assert (N : 0 < IZR (below (its_rates r))) by (apply IZR_lt, Hbelow).
assert (E : p_at r begin s tau = p_of (moment tau)).
{ unfold p_at, p_of, moment, p_slope, p_value. rewrite plus_IZR, !mult_IZR. fold ct h. field. lra. }
rewrite E.
apply (is_derive_comp (W i) moment tau (total coordinates (fun l => equations r (p_of (moment tau)) i l * U l tau)
  + forcing r i) (h / ct)).
- apply HW.
- unfold moment. auto_derive; auto. field. lra.
Qed.

Variable tube : vector Z.
Hypothesis Htube : forall tau, 0 <= tau <= 1 -> forall i, Rabs (U i tau - x r s i tau) <= IZR (tube i) / un.

Lemma un_split : un = gr * IZR (fine r) /\ 0 < gr /\ 0 < IZR (fine r) /\ 0 < un.
Proof.
assert (G : 0 < gr) by (apply IZR_lt, Hgrain). assert (F : 0 < IZR (fine r)) by (apply IZR_lt, Hfine).
assert (E : un = gr * IZR (fine r)) by (unfold un, unit; apply mult_IZR).
repeat split; auto. rewrite E. apply Rmult_lt_0_compat; auto.
Qed.

(** A sum of bounds in the unit of the polynomials. *)
Lemma coarser n : IZR n / un <= IZR (up n (fine r)) / gr.
Proof.
destruct un_split as (E & G & F & UP). assert (Q := up_le n (fine r) Hfine). rewrite E.
apply Rmult_le_reg_r with (gr * IZR (fine r)). rewrite <- E. exact UP.
replace (IZR n / (gr * IZR (fine r)) * (gr * IZR (fine r))) with (IZR n) by (field; lra).
replace (IZR (up n (fine r)) / gr * (gr * IZR (fine r))) with (IZR (fine r) * IZR (up n (fine r))) by (field; lra).
exact Q.
Qed.

Lemma force_near tau : 0 <= tau <= 1 ->
  Rabs (U of_z tau - U of_y tau - value tau (force s) / gr) <= IZR (up (tube of_z + tube of_y) (fine r)) / gr.
Proof.
intros Ht. destruct un_split as (E & G & F & UP). apply Rle_trans with (2 := coarser _). rewrite plus_IZR.
assert (Z1 := Htube tau Ht of_z). assert (Y1 := Htube tau Ht of_y).
unfold force. rewrite value_minus. unfold x in Z1, Y1. fold gr in Z1, Y1.
replace (U of_z tau - U of_y tau - (value tau (curve s of_z) - value tau (curve s of_y)) / gr)
  with ((U of_z tau - value tau (curve s of_z) / gr) - (U of_y tau - value tau (curve s of_y) / gr)) by (field; lra).
unfold Rdiv. rewrite Rmult_plus_distr_r. unfold Rminus at 1. apply Rabs_plus_le. exact Z1. rewrite Rabs_Ropp. exact Y1.
Qed.

Lemma contact_on_step tau : in_contact r s tube = true -> 0 <= tau <= 1 -> U of_y tau < U of_z tau.
Proof.
intros H Ht. destruct un_split as (E & G & F & UP). assert (P := positive_right _ _ _ H Ht).
rewrite value_less in P. assert (N := force_near tau Ht). apply Rabs_le_between in N.
set (d := IZR (up _ _)) in *. assert (0 < (value tau (force s) - d) / gr) by (apply Rdiv_lt_0_compat; auto).
unfold Rdiv in *. lra.
Qed.

Lemma falls tau : 0 <= tau <= 1 ->
  0 < value tau (less (falling s) (up (tube of_v + tube of_y + 2 * tube of_z) (fine r))) ->
  U of_y tau - 2 * U of_z tau - U of_v tau < 0.
Proof.
intros Ht H. destruct un_split as (E & G & F & UP). rewrite value_less in H.
assert (Q := coarser (tube of_v + tube of_y + 2 * tube of_z)). rewrite !plus_IZR, mult_IZR in Q.
set (d := IZR (up _ _)) in *.
assert (P : 0 < (value tau (falling s) - d) / gr) by (apply Rdiv_lt_0_compat; auto).
unfold falling in P. rewrite !value_minus, value_times in P.
assert (Z1 := Htube tau Ht of_z). assert (Y1 := Htube tau Ht of_y). assert (V1 := Htube tau Ht of_v).
unfold x in Z1, Y1, V1. fold gr in Z1, Y1, V1.
apply Rabs_le_between in Z1. apply Rabs_le_between in Y1. apply Rabs_le_between in V1.
unfold Rdiv in *. lra.
Qed.

(** The lift-off in the last step. Plan: lambda falls on [0, R] by [falls]; its signs at the two ticks follow from
    rounded values of the polynomial; the zero between them is the only one; last, the times. *)
Lemma lifts_off_sound : 0 < h -> lifts_off r begin s g tube = true -> exists tau, 0 < tau <= 1 /\
  (forall t, 0 <= t < tau -> U of_y t < U of_z t) /\ U of_y tau = U of_z tau /\
  U of_y tau - 2 * U of_z tau - U of_v tau < 0 /\
  Q2R (low g) < Q2R (eps g) * moment tau < Q2R (high g).
Proof.
intros Hh H. unfold lifts_off in H. cbv zeta in H. rewrite !andb_true_iff in H.
destruct H as ((((((((H1 & H2) & H3) & H4) & H5) & H6) & H7) & H8) & H9).
apply Z.ltb_lt in H1, H2, H3, H6, H7. apply Z.leb_le in H4. apply Qle_bool_iff, Qle_Rle in H8, H9.
destruct un_split as (E & G & F & UP). assert (C : 0 < ct) by (apply IZR_lt, Hclock).
set (tk := IZR (ticks r)). assert (Tk : 0 < tk) by (apply IZR_lt, H1).
set (L := IZR (left_tick r) / tk). set (R' := IZR (right_tick r) / tk).
assert (L0 : 0 < L) by (apply Rdiv_lt_0_compat; auto; apply IZR_lt; auto).
assert (LR : L < R'). { apply Rmult_lt_compat_r. apply Rinv_0_lt_compat, Tk. apply IZR_lt, H3. }
assert (P2 : 0 < 2 ^ halvings r) by (apply pow_lt; lra).
assert (RH : R' * 2 ^ halvings r <= 1).
{ apply IZR_le in H4. rewrite mult_IZR, <- pow_IZR in H4. fold tk in H4.
  replace (R' * 2 ^ halvings r) with (IZR (right_tick r) * 2 ^ halvings r / tk) by (unfold R'; field; lra).
  apply quotient_le; auto. lra. }
assert (R1 : R' <= 1).
{ assert (1 <= 2 ^ halvings r) by (apply pow_R1_Rle; lra).
  assert (R' * 1 <= R' * 2 ^ halvings r) by (apply Rmult_le_compat_l; lra). lra. }
assert (Fall : forall t, 0 <= t <= R' -> U of_y t - 2 * U of_z t - U of_v t < 0).
{ intros t Ht. apply falls. lra. replace t with (t * 2 ^ halvings r / 2 ^ halvings r) by (field; lra).
  apply halved_many. apply (positive_right _ _ _ H5). split. apply Rmult_le_pos; lra.
  assert (t * 2 ^ halvings r <= R' * 2 ^ halvings r) by (apply Rmult_le_compat_r; lra). lra. }
set (lam := fun t => U of_z t - U of_y t).
set (lam' := fun t => h / ct * (U of_y t - 2 * U of_z t - U of_v t)).
assert (D : forall t, is_derive lam t (lam' t)).
{ intros t. apply (is_derive_val _ _ (h / ct * (total coordinates (fun l =>
    equations r (p_at r begin s t) of_z l * U l t) + forcing r of_z)
    - h / ct * (total coordinates (fun l => equations r (p_at r begin s t) of_y l * U l t) + forcing r of_y))).
  - apply (is_derive_minus (U of_z) (U of_y)); apply U_derive.
  - unfold lam', total, coordinates. cbn [fold_right equations forcing]. ring. }
assert (Dec : forall a b, 0 <= a -> a < b -> b <= R' -> lam b < lam a).
{ intros a b Ha Hab Hb. destruct (mvt_open lam lam' a b Hab) as (c & Hc & Ec). intros; apply D.
  assert (N := Fall c ltac:(lra)).
  assert (0 < h / ct * - (U of_y c - 2 * U of_z c - U of_v c) * (b - a)).
  { apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; auto. }
  unfold lam' in Ec. lra. }
set (d := IZR (up (tube of_z + tube of_y) (fine r))) in *.
assert (LL : 0 < lam L).
{ assert (Q := rounded_near (ticks r) (left_tick r) (force s) H1
    ltac:(split; [lia|]; apply le_IZR; apply Rmult_le_reg_r with (/ tk); [apply Rinv_0_lt_compat, Tk|];
      fold tk; rewrite Rinv_r by lra; change (L <= 1); lra)).
  fold tk L in Q. apply Rabs_le_between in Q. apply IZR_lt in H6. rewrite plus_IZR in H6. fold d in H6.
  assert (N := force_near L ltac:(lra)). fold (lam L) d in N. apply Rabs_le_between in N.
  assert (0 < (value L (force s) - d) / gr) by (apply Rdiv_lt_0_compat; lra).
  unfold Rdiv in *. lra. }
assert (LR' : lam R' < 0).
{ assert (Q := rounded_near (ticks r) (right_tick r) (force s) H1
    ltac:(split; [lia|]; apply le_IZR; apply Rmult_le_reg_r with (/ tk); [apply Rinv_0_lt_compat, Tk|];
      fold tk; rewrite Rinv_r by lra; change (R' <= 1); lra)).
  fold tk R' in Q. apply Rabs_le_between in Q. apply IZR_lt in H7. rewrite opp_IZR, plus_IZR in H7. fold d in H7.
  assert (N := force_near R' ltac:(lra)). fold (lam R') d in N. apply Rabs_le_between in N.
  assert (0 < (- value R' (force s) - d) / gr) by (apply Rdiv_lt_0_compat; lra).
  unfold Rdiv in *. lra. }
destruct (IVT_gen lam L R' 0) as (t & Ht & Et).
{ intros y. apply continuity_pt_filterlim, (ex_derive_continuous lam y). eexists. apply D. }
{ rewrite Rmin_right, Rmax_left by lra. lra. }
rewrite Rmin_left, Rmax_right in Ht by lra.
assert (Ht' : L < t < R').
{ split; apply Rnot_le_lt; intros Hle; [replace t with L in Et by lra|replace t with R' in Et by lra]; lra. }
exists t. split; [lra|]. split; [|split; [unfold lam in Et; lra|split; [apply Fall; lra|]]].
- intros a Ha. assert (Q := Dec a t ltac:(lra) ltac:(lra) ltac:(lra)). unfold lam in *. lra.
- unfold time_at in H8, H9. rewrite !Q2R_mult in H8, H9.
  assert (I : forall z, Q2R (inject_Z z) = IZR z) by (intros z; unfold Q2R, inject_Z; simpl; field).
  rewrite !I, !plus_IZR, !mult_IZR in H8, H9. fold ct tk h in H8, H9.
  assert (EL : IZR (left_tick r) = L * tk) by (unfold L; field; lra).
  assert (ER : IZR (right_tick r) = R' * tk) by (unfold R'; field; lra). rewrite EL in H8. rewrite ER in H9.
  assert (M : forall a b, a < b -> Q2R (eps g) * (IZR begin * tk + h * (a * tk))
    < Q2R (eps g) * (IZR begin * tk + h * (b * tk))).
  { intros a b Hab. apply Rmult_lt_compat_l; auto. apply Rplus_lt_compat_l, Rmult_lt_compat_l; auto. }
  assert (M1 := M L t ltac:(lra)). assert (M2 := M t R' ltac:(lra)).
  assert (CT : 0 < ct * tk) by (apply Rmult_lt_0_compat; auto).
  assert (EM : Q2R (eps g) * moment t * (ct * tk) = Q2R (eps g) * (IZR begin * tk + h * (t * tk)))
    by (unfold moment; field; lra).
  split; apply Rmult_lt_reg_r with (ct * tk); auto; rewrite EM; lra.
Qed.
End Step.

Lemma all_steps_sound : forall l begin before middle, all_steps r g begin before middle l = true ->
  near r before (fun i => W i (IZR begin / ct) - IZR (middle i) / gr) ->
  exists T, IZR begin / ct < T /\ (forall t, IZR begin / ct <= t < T -> W of_y t < W of_z t) /\ W of_y T = W of_z T /\
    W of_y T - 2 * W of_z T - W of_v T < 0 /\ Q2R (low g) < Q2R (eps g) * T < Q2R (high g).
Proof.
assert (C : 0 < ct) by (apply IZR_lt, Hclock).
induction l as [|s l IH]; intros begin before middle H Hn; [discriminate|]. cbn [all_steps] in H.
destruct (one_step r begin s before middle) as [[after tube]|] eqn:O; [|discriminate].
assert (Hh : (0 < duration s)%Z). { unfold one_step in O. cbv zeta in O. destruct (0 <? duration s)%Z eqn:E;
  [|discriminate].
  apply Z.ltb_lt, E. }
assert (Hh' : 0 < IZR (duration s)) by (apply IZR_lt, Hh).
assert (At0 : moment begin s 0 = IZR begin / ct) by (unfold moment; fold ct; field; lra).
assert (At1 : moment begin s 1 = IZR (begin + duration s) / ct) by (unfold moment; rewrite plus_IZR; fold ct; field;
  lra).
destruct (one_step_sound r Hclock Hgrain Hfine Hscale Hbelow begin s Hh' (U begin s) (U_derive begin s) before middle
  after tube O) as [S1 S2].
{ destruct Hn as (z & E1 & E2). exists z. split; auto. intros i. rewrite <- E1. unfold U. rewrite At0. reflexivity. }
assert (Inside : forall t, IZR begin / ct <= t -> exists tau, 0 <= tau /\ moment begin s tau = t).
{ intros t Ht. exists ((t * ct - IZR begin) / IZR (duration s)). split.
  - apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; auto].
    assert (IZR begin / ct * ct <= t * ct) by (apply Rmult_le_compat_r; lra).
    replace (IZR begin / ct * ct) with (IZR begin) in * by (field; lra). lra.
  - unfold moment. fold ct. field. lra. }
assert (Order : forall a b, moment begin s a < moment begin s b -> a < b).
{ intros a b Hab. apply Rnot_le_lt. intros Hle. unfold moment in Hab. fold ct in Hab.
  apply (Rmult_lt_compat_r ct) in Hab; auto.
  replace ((IZR begin + IZR (duration s) * a) / ct * ct) with (IZR begin + IZR (duration s) * a) in Hab by (field; lra).
  replace ((IZR begin + IZR (duration s) * b) / ct * ct) with (IZR begin + IZR (duration s) * b) in Hab by (field; lra).
  assert (IZR (duration s) * b <= IZR (duration s) * a) by (apply Rmult_le_compat_l; lra). lra. }
destruct l as [|s' l].
- destruct (lifts_off_sound begin s tube S2 Hh' H) as (tau & T1 & T2 & T3 & T4 & T5).
  exists (moment begin s tau). split.
  { rewrite <- At0. apply Rmult_lt_compat_r. apply Rinv_0_lt_compat, C.
    assert (0 < IZR (duration s) * tau) by (apply Rmult_lt_0_compat; lra). lra. }
  split; [|auto]. intros t Ht. destruct (Inside t ltac:(lra)) as (a & Ha & <-). apply T2. split; auto.
  apply Order. lra.
- destruct (in_contact r s tube) eqn:I; [|discriminate].
  destruct (IH (begin + duration s)%Z after (end_of s) H) as (T & B1 & B2 & B3).
  { destruct S1 as (z & E1 & E2). exists z. split; auto. intros i. rewrite <- E1. unfold U. rewrite At1. reflexivity. }
  assert (Next : IZR begin / ct < IZR (begin + duration s) / ct).
  { apply Rmult_lt_compat_r. apply Rinv_0_lt_compat, C. apply IZR_lt. lia. }
  exists T. split. lra. split; [|exact B3]. intros t Ht.
  destruct (Rlt_dec t (IZR (begin + duration s) / ct)) as [Hlt|Hge]; [|apply B2; lra].
  destruct (Inside t ltac:(lra)) as (a & Ha & <-). apply (contact_on_step begin s tube S2 a I). split; auto.
  apply Rlt_le, Order. lra.
Qed.

End Run.
