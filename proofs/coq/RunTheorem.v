(** * What an accepted run proves of the mechanism *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import StatementCompliant StatementFlight InitialValueProblem CompliantMotion Checker CheckerModels
  Calculus StatementStep
  LogarithmicNorm BlockGrowth RunScene RunChecker RunArithmetic RunSound RunLiftOff.
Import ListNotations.
Open Scope R_scope.

Lemma inject_real z : Q2R (inject_Z z) = IZR z.
Proof. unfold Q2R, inject_Z. simpl. field. Qed.

Lemma equal_real p q : Qeq_bool p q = true -> Q2R p = Q2R q.
Proof. intros H. apply Qeq_eqR, Qeq_bool_iff, H. Qed.

Lemma not_above_0 q : Qle_bool q 0 = false -> 0 < Q2R q.
Proof.
intros H. apply Rnot_le_lt. intros Hle. replace 0 with (Q2R 0) in Hle by (unfold Q2R; simpl; field).
apply Rle_Qle, Qle_bool_iff in Hle. congruence.
Qed.

Lemma accepted_eps r g : run_accepted r g = true -> 0 < Q2R (eps g).
Proof.
intros H. unfold run_accepted in H. destruct (numbers_fit r g) eqn:P; [|discriminate]. unfold numbers_fit in P.
rewrite !andb_true_iff in P. apply not_above_0, negb_true_iff, P.
Qed.

(** How far the start is from the first polynomials. *)
Lemma away_bound r q m x : (0 < grain r)%Z -> (0 < fine r)%Z -> x = Q2R q ->
  Rabs (x - IZR m / IZR (grain r)) <= IZR (away r q m) / IZR (unit r).
Proof.
intros Hg Hf ->. assert (G : 0 < IZR (grain r)) by (apply IZR_lt, Hg).
assert (F : 0 < IZR (fine r)) by (apply IZR_lt, Hf).
assert (U : 0 < IZR (unit r)) by (unfold unit; rewrite mult_IZR; apply Rmult_lt_0_compat; auto).
unfold away. cbv zeta. set (d := ((q * inject_Z (grain r) - inject_Z m) * inject_Z (fine r))%Q).
assert (D : Q2R d = (Q2R q - IZR m / IZR (grain r)) * IZR (unit r)).
{ unfold d, unit. rewrite Q2R_mult, Q2R_minus, Q2R_mult, !inject_real, mult_IZR. field. lra. }
apply Rmult_le_reg_r with (IZR (unit r)); auto.
replace (IZR (up (Z.abs (Qnum d)) (QDen d)) / IZR (unit r) * IZR (unit r)) with (IZR (up (Z.abs (Qnum d)) (QDen d)))
  by (field; lra).
rewrite <- (Rabs_pos_eq (IZR (unit r))) at 1 by lra. rewrite <- Rabs_mult, <- D. unfold Q2R.
fold (Rdiv (IZR (Qnum d)) (IZR (QDen d))).
rewrite quotient_abs, <- abs_IZR by (apply IZR_lt; reflexivity). apply up_quotient. reflexivity.
Qed.

(** From the start of the scene at t = 0 there is a first lift-off, within the bracket, and contact before it.
    Plan: the motion with the linear law of force exists on the whole line; in the units of eps it solves the equations
    of the checker (HW), so [all_steps_sound] holds for it; up to the lift-off it solves those of the mechanism, whose
    motion is unique. *)
Theorem accepted_run r g p b y v z : run_accepted r g = true ->
  let e := Q2R (eps g) in
  mechanism_from (Q2R (alpha1 g)) (Q2R (alpha2 g)) (Q2R (alpha1 g * beta g)) e 0 p b y v z ->
  p 0 = Q2R (p0 g) -> b 0 = Q2R (b0 g) -> y 0 = Q2R (y0 g) -> v 0 = Q2R (v0 g) -> z 0 = Q2R (z0 g) ->
  exists t1, 0 < t1 /\ Q2R (low g) < t1 < Q2R (high g) /\ (forall t, 0 <= t < t1 -> y t < z t) /\
    lift_off_at e y v z t1.
Proof.
intros H e Hm Ep Eb Ey Ev Ez. unfold run_accepted in H.
destruct (numbers_fit r g) eqn:P; [rename H into H8|discriminate].
unfold numbers_fit in P. rewrite !andb_true_iff in P. destruct P as (((((H1 & H2) & H3) & H4) & H5) & H6).
apply Z.ltb_lt in H1, H2, H3, H4. apply negb_true_iff in H5.
assert (He : 0 < e) by exact (not_above_0 (eps g) H5).
unfold same_rates in H6. rewrite !andb_true_iff in H6. destruct H6 as ((((R0 & R1) & R2) & R3) & R4).
apply Z.ltb_lt in R0. apply equal_real in R1, R2, R3, R4. rewrite ?Q2R_mult, ?inject_real in R1. rewrite ?Q2R_mult,
  ?inject_real in R2.
rewrite ?Q2R_mult, ?inject_real in R3. rewrite ?Q2R_mult, ?inject_real in R4.
fold e in R1, R2, R3.
set (N := IZR (below (its_rates r))) in *. assert (NP : 0 < N) by (apply IZR_lt, R0).
set (gr := IZR (grain r)) in *. assert (G : 0 < gr) by (apply IZR_lt, H2).
set (a1 := Q2R (alpha1 g)) in *. set (a2 := Q2R (alpha2 g)) in *. set (a3 := Q2R (alpha1 g * beta g)) in *.
fold a1 in R1, R3. fold a2 in R2.
assert (A3 : e * a3 * N = IZR (rate3 (its_rates r))) by (rewrite <- R3; unfold a3, a1; rewrite Q2R_mult; reflexivity).
destruct (CompliantMotion.motion_exists a1 a2 a3 e He linear_force (linear_lipschitz e He) 0 (p 0) (b 0) (y 0) (v 0)
  (z 0))
  as (P & B & Y & V & Z & M & P0 & B0 & Y0 & V0 & Z0).
set (W := fun i T => match i with of_b => B (e * T) | of_y => Y (e * T) / e ^ 2 | of_v => V (e * T) / e
  | of_z => Z (e * T) / e ^ 2 end).
assert (PT : forall T, P (e * T) = p_of r T).
{ intros T. rewrite (affine a1 P 0 (e * T)). 2: { intros s _. apply (M s). }
  rewrite P0, Ep. unfold p_of. fold N. rewrite <- R1, <- R4. field. lra. }
assert (Chain : forall f l T, is_derive f (e * T) l -> is_derive (fun T => f (e * T)) T (e * l)).
{ intros f l T D. apply (is_derive_comp f (fun T => e * T) T l e D). auto_derive; auto. ring. }
assert (HW : forall i T,
  is_derive (W i) T (total coordinates (fun l => equations r (p_of r T) i l * W l T) + forcing r i)).
{ intros i T. destruct (M (e * T)) as (_ & DB & DY & DV & DZ).
  unfold linear_force in DB, DV, DZ. rewrite PT in DV. unfold total, coordinates.
  destruct i; cbn [fold_right equations forcing W]; fold N.
  - eapply is_derive_val. apply (Chain B _ T DB). unfold W. rewrite <- A3, <- R2. field. lra.
  - apply (is_derive_ext (fun T => / e ^ 2 * Y (e * T))). { intros t. unfold W. match goal with |- ?l = ?m => change
    (@eq R l m) end. field. lra. }
    eapply is_derive_val. apply (is_derive_scal (fun T => Y (e * T)) T (/ e ^ 2)), (Chain Y _ T DY).
    unfold W. field. lra.
  - apply (is_derive_ext (fun T => / e * V (e * T))). { intros t. unfold W. match goal with |- ?l = ?m => change (@eq
    R l m) end. field. lra. }
    eapply is_derive_val. apply (is_derive_scal (fun T => V (e * T)) T (/ e)), (Chain V _ T DV).
    unfold W. field. lra.
  - apply (is_derive_ext (fun T => / e ^ 3 * (fun t => e * Z t) (e * T))). { intros t. unfold W. match goal with |- ?l
    = ?m => change (@eq R l m) end. field. lra. }
    eapply is_derive_val.
    apply (is_derive_scal (fun T => (fun t => e * Z t) (e * T)) T (/ e ^ 3)), (Chain (fun t => e * Z t) _ T DZ).
    unfold W. field. lra. }
destruct (all_steps_sound r g H1 H2 H3 H4 R0 He W HW (steps r) 0 (first_errors r g) (first_middle r) H8) as
  (T & T1 & T2 & T3 & T4 & T5).
{ exists (fun i => W i (0 / IZR (clock r)) - IZR (first_middle r i) / gr). split.
  - intros i. unfold first_errors. cbn [its_basis]. rewrite delta_sum. rewrite Rmult_1_l. reflexivity.
  - assert (Far : forall i, Rabs (W i (0 / IZR (clock r)) - IZR (first_middle r i) / gr)
      <= IZR (radii (first_errors r g) i) / IZR (unit r)).
    { intros i. replace (0 / IZR (clock r)) with 0 by (unfold Rdiv; ring). unfold W, gr. rewrite Rmult_0_r.
      assert (E2 : ~ (eps g * eps g == 0)%Q).
      { intros E. apply Qeq_eqR in E. rewrite Q2R_mult in E. fold e in E. unfold Q2R at 1 in E. simpl in E. nra. }
      assert (E1 : ~ (eps g == 0)%Q). { intros E. apply E2. rewrite E. reflexivity. }
      destruct i; apply away_bound; auto.
      - rewrite B0, Eb. reflexivity.
      - rewrite Y0, Ey, Q2R_div, Q2R_mult by exact E2. fold e. field. lra.
      - rewrite V0, Ev, Q2R_div by exact E1. reflexivity.
      - rewrite Z0, Ez, Q2R_div, Q2R_mult by exact E2. fold e. field. lra. }
    intros k. unfold first_errors at 1. cbn [its_blocks]. specialize (Far k). split.
    + eapply Rle_trans. apply Rabs_pos. exact Far.
    + rewrite <- (pow2_abs (IZR _ / _)). rewrite (Rabs_pos_eq (IZR _ / _))
        by (eapply Rle_trans; [apply Rabs_pos|exact Far]).
      eapply Rle_trans; [|apply pow_incr; split; [apply Rabs_pos|exact Far]]. rewrite pow2_abs.
      apply Req_le. unfold square, total, coordinates, part, lies. cbn [fold_right]. destruct k; cbn [same]; ring. }
replace (0 / IZR (clock r)) with 0 in T1, T2 by (unfold Rdiv; ring).
set (t1 := e * T). assert (Pos : 0 < t1) by (apply Rmult_lt_0_compat; auto).
assert (Inside : forall t, 0 <= t < t1 -> Y t < Z t).
{ intros t Ht. assert (Q : W of_y (t / e) < W of_z (t / e)).
  { apply T2. split. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, He.
    apply Rmult_lt_reg_r with e; auto. replace (t / e * e) with t by (field; lra). unfold t1 in Ht. lra. }
  unfold W in Q. replace (e * (t / e)) with t in Q by (field; lra).
  apply Rmult_lt_reg_r with (/ e ^ 2). apply Rinv_0_lt_compat, pow_lt, He. exact Q. }
assert (End : Y t1 = Z t1).
{ unfold W in T3. fold t1 in T3. apply Rmult_eq_reg_r with (/ e ^ 2). exact T3.
  apply Rgt_not_eq, Rinv_0_lt_compat, pow_lt, He. }
assert (Same : forall t, 0 <= t <= t1 -> p t = P t /\ b t = B t /\ y t = Y t /\ v t = V t /\ z t = Z t).
{ intros t Ht. assert (Sg : forall s, InitialValueProblem.segment 0 t s -> 0 <= s <= t1).
  { intros s. unfold InitialValueProblem.segment. rewrite Rmin_left, Rmax_right by lra. lra. }
  apply (CompliantMotion.motion_unique a1 a2 a3 e He contact_force (contact_lipschitz e He) p b y v z P B Y V Z 0 t).
  - intros s Hs. apply Hm. apply (Sg s Hs).
  - intros s Hs. specialize (Sg s Hs). assert (F : contact_force e (Y s) (Z s) = linear_force e (Y s) (Z s)).
    { unfold contact_force, linear_force. destruct (Rlt_dec (Y s) (Z s)) as [L|L]; auto.
      destruct (Req_dec s t1) as [->|Ne]; [rewrite End; unfold Rdiv; ring|].
      exfalso. apply L, Inside. lra. }
    unfold model_at. rewrite F. apply M.
  - auto. - auto. - auto. - auto. - auto. }
exists t1. split; auto. split; [exact T5|]. split.
- intros t Ht. destruct (Same t ltac:(lra)) as (_ & _ & E1 & _ & E2). rewrite E1, E2. apply Inside, Ht.
- destruct (Same t1 ltac:(lra)) as (_ & _ & E1 & E3 & E2). split. rewrite E1, E2. exact End.
  unfold separation_rate. rewrite E3, E2. unfold W in T4. fold t1 in T4. rewrite End in T4.
  apply Rmult_lt_reg_r with (/ e). apply Rinv_0_lt_compat, He. rewrite Rmult_0_l.
  replace ((V t1 + Z t1 / e) * / e) with (V t1 / e + Z t1 / e ^ 2) by (field; lra). lra.
Qed.
