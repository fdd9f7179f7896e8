(** * The checker of runs is right

    What [run_accepted] of [RunChecker.v] accepts is true. The plan follows the checker: one piece ([piece_sound],
    Theorems N1' and N2 by [block_growth]); one step; the steps one after the other; the lift-off. The motion is that of
    the linear law of force, which exists on the whole line; up to the lift-off it is the motion of the mechanism. *)

From Coq Require Import Reals Psatz Lra Lia ZArith QArith Qreals List Bool.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import CompliantMotion Checker CheckerModels Calculus StatementStep LogarithmicNorm BlockGrowth
  RunChecker RunArithmetic.
Import ListNotations.
Open Scope R_scope.

Section Run.
Variable r : run.
Hypothesis Hclock : (0 < clock r)%Z.
Hypothesis Hgrain : (0 < grain r)%Z.
Hypothesis Hfine : (0 < fine r)%Z.
Hypothesis Hscale : (0 < scale r)%Z.
Hypothesis Hbelow : (0 < below (its_rates r))%Z.
Let ct := IZR (clock r).
Let N := IZR (below (its_rates r)).
Let cm := IZR (scale r).
Let un := IZR (unit r).

Lemma ct_pos : 0 < ct. Proof. apply IZR_lt, Hclock. Qed.
Lemma N_pos : 0 < N. Proof. apply IZR_lt, Hbelow. Qed.
Lemma cm_pos : 0 < cm. Proof. apply IZR_lt, Hscale. Qed.
Lemma un_pos : 0 < un. Proof. apply IZR_lt. unfold unit. apply Z.mul_pos_pos; auto. Qed.

(** The matrix of the equations in b, Y, V, Z at p. *)
Definition equations (p : R) (i l : coordinate) : R :=
  match i, l with
  | of_b, of_y => IZR (rate3 (its_rates r)) / N | of_b, of_z => - (IZR (rate3 (its_rates r)) / N)
  | of_y, of_v => 1
  | of_v, of_b => 1 | of_v, of_y => - p | of_v, of_z => p
  | of_z, of_y => 1 | of_z, of_z => -2
  | _, _ => 0
  end.

(** The errors e are S zeta, and each block of zeta is within its bound. *)
Definition near (er : errors) (e : coordinate -> R) : Prop := exists zeta,
  (forall i, e i = total coordinates (fun l => IZR (its_basis er i l) * zeta l)) /\
  forall k, within coordinates (lies (its_blocks er)) k zeta (IZR (radii er k) / un).

Section Step.
Variables (begin : Z) (s : step).
Let h := IZR (duration s).
Hypothesis Hh : 0 < h.

Definition p_at (tau : R) : R := (IZR (p_slope r s) * tau + IZR (p_value r begin)) / (N * ct).

Section Piece.
Variables (defect : vector Z) (left_end : Z) (before : errors) (jump : vector Z) (c : piece).
Variables (e D : coordinate -> R -> R).
Let S i l := IZR (basis c i l).
Let inv i l := IZR (inverse c i l).
Let det := IZR (determinant c).
Let bl := blocks c.
Let pb := IZR (p_below r).
Let t0 := IZR left_end / ct.
Let t1 := IZR (right_end c) / ct.
Hypothesis Hdet : (0 < determinant c)%Z.
Hypothesis Hends : (left_end < right_end c)%Z.
Hypothesis Hinverse : is_inverse c = true.
Hypothesis He : forall i tau, t0 <= tau <= t1 ->
  is_derive (e i) tau (h / ct * total coordinates (fun l => equations (p_at tau) i l * e l tau) + D i tau).
Hypothesis HD : forall i tau, t0 <= tau <= t1 -> Rabs (D i tau) <= IZR (defect i) / un.
Hypothesis Hbefore : near before (fun i => e i t0 - IZR (jump i) / un).

Lemma det_pos : 0 < det. Proof. apply IZR_lt, Hdet. Qed.
Lemma pb_pos : 0 < pb.
Proof. apply IZR_lt. unfold p_below. apply Z.mul_pos_pos; auto. apply Z.mul_pos_pos; [lia|]. apply Z.mul_pos_pos;
  auto. Qed.

Definition zeta (l : coordinate) (tau : R) : R := total coordinates (fun m => inv l m * e m tau) / det.

Lemma times_inverse (v : coordinate -> R) i :
  total coordinates (fun l => S i l * (total coordinates (fun m => inv l m * v m) / det)) = v i.
Proof.
assert (P := det_pos).
rewrite (total_ext coordinates _ (fun l => / det * (S i l * total coordinates (fun m => inv l m * v m))))
  by (intros; field; lra).
rewrite total_scal, double_sum.
rewrite (total_ext coordinates _ (fun m => IZR (if same i m then determinant c else 0%Z) * v m)).
- rewrite delta_sum. fold det. field. lra.
- intros m. f_equal. assert (H := every_true _ (every_true _ Hinverse i) m). simpl in H. apply Z.eqb_eq in H.
  rewrite <- H, sum_real. apply total_ext. intros l. rewrite mult_IZR. reflexivity.
Qed.

Lemma errors_are i tau : e i tau = total coordinates (fun l => S i l * zeta l tau).
Proof. symmetry. apply (times_inverse (fun m => e m tau)). Qed.

(** The matrix in the basis. *)
Definition B (tau : R) (l q : coordinate) : R :=
  total coordinates (fun m => inv l m * total coordinates (fun n => equations (p_at tau) m n * S n q)) / det.
Definition push (l : coordinate) (tau : R) : R := total coordinates (fun m => inv l m * D m tau) / det.

Lemma zeta_derive l tau : t0 <= tau <= t1 ->
  is_derive (zeta l) tau (h / ct * total coordinates (fun q => B tau l q * zeta q tau) + push l tau).
Proof.
intros Ht. unfold zeta at 1. assert (P := det_pos). assert (Q := ct_pos).
set (A := fun m => total coordinates (fun n => equations (p_at tau) m n * e n tau)).
apply (is_derive_val _ _ (total coordinates (fun m => inv l m * (h / ct * A m + D m tau)) * / det)).
- apply (is_derive_ext (fun t => total coordinates (fun m => inv l m * e m t) * / det)). { reflexivity. }
  eapply is_derive_val.
  + apply (is_derive_mult_R (fun t => total coordinates (fun m => inv l m * e m t)) (fun _ => / det) tau
      (total coordinates (fun m => inv l m * (h / ct * A m + D m tau))) 0).
    * apply (total_derive coordinates (fun m t => inv l m * e m t) (fun m t => inv l m * (h / ct * A m + D m t))).
      intros m.
      apply (is_derive_scal (e m) tau (inv l m)), He, Ht.
    * apply (is_derive_const (/ det)).
  + ring.
- assert (E : forall m, A m = total coordinates (fun q =>
    total coordinates (fun n => equations (p_at tau) m n * S n q) * zeta q tau)).
  { intros m. unfold A. rewrite <- double_sum. apply total_ext. intros n. rewrite errors_are. reflexivity. }
  rewrite (total_ext coordinates _ (fun m => h / ct * (inv l m * A m) + inv l m * D m tau)) by (intros; ring).
  rewrite total_plus, total_scal.
  rewrite (total_ext coordinates (fun m => inv l m * A m) (fun m => inv l m * total coordinates (fun q =>
    total coordinates (fun n => equations (p_at tau) m n * S n q) * zeta q tau))) by (intros; rewrite E; reflexivity).
  rewrite double_sum. unfold push, B.
  rewrite (total_ext coordinates (fun q => _ / det * zeta q tau) (fun q => / det * (total coordinates (fun m =>
    inv l m * total coordinates (fun n => equations (p_at tau) m n * S n q)) * zeta q tau))) by (intros; field; lra).
  rewrite total_scal. field. lra.
Qed.

(** ** The bounds of the matrix *)
Lemma p_near tau : t0 <= tau <= t1 ->
  Rabs (p_at tau * pb - IZR (p_middle r begin s left_end c)) <= IZR (p_radius r s left_end c).
Proof.
intros [H0 H1]. assert (P := ct_pos). assert (Q := N_pos).
unfold p_middle, p_radius, pb, p_below, p_at.
rewrite !plus_IZR, !mult_IZR, abs_IZR, minus_IZR, plus_IZR. fold N ct.
set (sl := IZR (p_slope r s)). set (va := IZR (p_value r begin)).
replace ((sl * tau + va) / (N * ct) * (2 * (N * ct) * ct) - (2 * (va * ct) + sl * (IZR left_end + IZR (right_end c))))
  with (sl * (2 * (ct * tau) - IZR left_end - IZR (right_end c))) by (field; lra).
rewrite Rabs_mult. apply Rmult_le_compat_l. apply Rabs_pos.
assert (L0 : IZR left_end = ct * t0) by (unfold t0; field; lra).
assert (L1 : IZR (right_end c) = ct * t1) by (unfold t1; field; lra). rewrite L0, L1.
assert (ct * t0 <= ct * tau) by (apply Rmult_le_compat_l; lra).
assert (ct * tau <= ct * t1) by (apply Rmult_le_compat_l; lra). apply Rabs_le. lra.
Qed.

Let T l q := IZR (turned r begin s left_end c l q).
Let E l q := IZR (turned_radius r s left_end c l q).

Lemma B_near tau l q : t0 <= tau <= t1 -> Rabs (B tau l q * (det * pb) - T l q) <= E l q.
Proof.
intros Ht. assert (P := det_pos). assert (Q := N_pos). assert (C := ct_pos).
assert (X : B tau l q * (det * pb) - T l q
  = inv l of_v * (S of_z q - S of_y q) * (p_at tau * pb - IZR (p_middle r begin s left_end c))).
{ assert (ET : T l q = total coordinates (fun m => inv l m * IZR (field_times r begin s left_end c q m))).
  { unfold T, turned. cbv zeta. rewrite !stored_same, sum_real. apply total_ext. intros m.
    rewrite mult_IZR. reflexivity. }
  set (F := fun m => total coordinates (fun n => equations (p_at tau) m n * S n q)).
  assert (EB : B tau l q * (det * pb) = total coordinates (fun m => inv l m * (pb * F m))).
  { change (total coordinates (fun m => inv l m * F m) / det * (det * pb)
      = total coordinates (fun m => inv l m * (pb * F m))).
    rewrite (total_ext coordinates (fun m => inv l m * (pb * F m))
      (fun m => pb * (inv l m * F m))) by (intros; ring).
    rewrite total_scal. field. lra. }
  assert (EP : pb = 2 * (N * ct) * ct) by (unfold pb, p_below; rewrite !mult_IZR; reflexivity).
  assert (EF : forall m, pb * F m - IZR (field_times r begin s left_end c q m) = match m with of_v =>
    (S of_z q - S of_y q) * (p_at tau * pb - IZR (p_middle r begin s left_end c)) | _ => 0 end).
  { intros m. unfold field_times. rewrite stored_same. unfold F, total, coordinates. cbn [fold_right].
    destruct m; cbn [row equations]; rewrite ?plus_IZR, ?mult_IZR, ?minus_IZR, ?mult_IZR; fold ct pb; unfold S;
      try rewrite EP; field; lra. }
  rewrite EB, ET, <- total_minus.
  rewrite (total_ext coordinates _ (fun m => inv l m * match m with of_v =>
    (S of_z q - S of_y q) * (p_at tau * pb - IZR (p_middle r begin s left_end c)) | _ => 0 end)).
  - unfold total, coordinates. cbn [fold_right]. ring.
  - intros m. rewrite <- EF. ring. }
rewrite X. unfold E, turned_radius. rewrite !stored_same, !mult_IZR, !abs_IZR, minus_IZR, !Rabs_mult.
apply Rmult_le_compat_l. apply Rmult_le_pos; apply Rabs_pos. apply p_near, Ht.
Qed.

(** C bounds B; M and d are what the checker accepts. *)
Let TT := turned r begin s left_end c.
Let EE := turned_radius r s left_end c.
Variables (M : matrix) (d : vector Z).
Hypothesis Hgrowth : growth_bounded r c TT EE M = true.
Hypothesis Hpush : lengths_bounded c (turned_defect defect c) d = true.
Let C i l := IZR (sizes r c TT EE i l) / cm.

Lemma scaled_up (x : R) a : Rabs x * (det * pb) <= IZR a -> Rabs x <= IZR (up (a * scale r) (determinant c * p_below
  r)) / cm.
Proof.
intros H. assert (P := det_pos). assert (Q := pb_pos). assert (K := cm_pos).
assert (DP : 0 < det * pb) by (apply Rmult_lt_0_compat; auto).
apply Rmult_le_reg_r with cm; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
apply Rle_trans with (IZR (a * scale r) / IZR (determinant c * p_below r)).
- rewrite !mult_IZR. fold det pb cm. apply Rmult_le_reg_r with (det * pb); auto.
  replace (IZR a * cm / (det * pb) * (det * pb)) with (IZR a * cm) by (field; lra).
  replace (Rabs x * cm * (det * pb)) with (Rabs x * (det * pb) * cm) by ring. apply Rmult_le_compat_r; lra.
- apply up_quotient. apply Z.mul_pos_pos; auto. apply lt_IZR, Q.
Qed.

Lemma B_size tau i l : t0 <= tau <= t1 -> Rabs (B tau i l) <= C i l.
Proof.
intros Ht. unfold C, sizes. rewrite !stored_same. apply scaled_up. rewrite plus_IZR, abs_IZR.
assert (P := det_pos). assert (Q := pb_pos). assert (H := B_near tau i l Ht).
assert (DP : 0 < det * pb) by (apply Rmult_lt_0_compat; auto).
rewrite <- (Rabs_pos_eq (det * pb)), <- Rabs_mult by lra.
replace (B tau i l * (det * pb)) with (T i l + (B tau i l * (det * pb) - T i l)) by ring.
eapply Rle_trans. apply Rabs_triang. apply Rplus_le_compat_l, H.
Qed.

Lemma diagonal_bounded tau j i : t0 <= tau <= t1 -> lies bl j i = true ->
  B tau i i - Rabs (B tau i i) + total coordinates (part (lies bl) j (fun l => Rabs (B tau i l + B tau l i))) / 2
    <= IZR (M j j) / cm.
Proof.
intros Ht Hi. assert (P := det_pos). assert (Q := pb_pos). assert (K := cm_pos).
assert (DP : 0 < det * pb) by (apply Rmult_lt_0_compat; auto).
assert (DZ : (0 < determinant c * p_below r)%Z) by (apply Z.mul_pos_pos; auto; apply lt_IZR, Q).
assert (H := every_true _ (every_true _ Hgrowth j) j). simpl in H.
rewrite (proj2 (same_iff j j) eq_refl) in H. apply (every_true _) with (i := i) in H. fold bl in H. rewrite Hi in H.
simpl in H. apply Z.leb_le in H. apply IZR_le in H.
apply Rle_trans with (IZR (disc r c TT EE j i) / cm).
2: { unfold Rdiv. apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, K. }
unfold disc. fold bl. rewrite plus_IZR.
set (off := fun l => if same i l then 0%Z else
  up ((Z.abs (TT i l + TT l i) + (EE i l + EE l i)) * scale r) (determinant c * p_below r)).
assert (D1 : B tau i i <= IZR (up ((TT i i + EE i i) * scale r) (determinant c * p_below r)) / cm).
{ assert (U := up_quotient ((TT i i + EE i i) * scale r) _ DZ). apply Rmult_le_reg_r with cm; auto.
  unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply Rle_trans with (2 := U).
  rewrite !mult_IZR, plus_IZR. fold det pb cm. apply Rmult_le_reg_r with (det * pb); auto.
  replace ((IZR (TT i i) + IZR (EE i i)) * cm / (det * pb) * (det * pb)) with ((IZR (TT i i) + IZR (EE i i)) * cm)
    by (field; lra).
  assert (N1 := B_near tau i i Ht). apply Rabs_le_between in N1. unfold T, E in N1. fold TT EE in N1.
  replace (B tau i i * cm * (det * pb)) with (B tau i i * (det * pb) * cm) by ring. apply Rmult_le_compat_r; lra. }
assert (D2 : total coordinates (part (lies bl) j (fun l => Rabs (B tau i l + B tau l i))) / 2 - Rabs (B tau i i)
  <= IZR (up (sum_over bl j off) 2) / cm).
{ assert (U := up_quotient (sum_over bl j off) 2 ltac:(lia)). rewrite sum_over_real in U.
  apply Rmult_le_reg_r with cm; auto.
  unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply Rle_trans with (2 := U).
  assert (X : total coordinates (part (lies bl) j (fun l => Rabs (B tau i l + B tau l i)))
    <= total coordinates (fun l => part (lies bl) j (fun l => IZR (off l) / cm) l) + 2 * Rabs (B tau i i)).
  { replace (2 * Rabs (B tau i i)) with (total coordinates (fun m => IZR (if same i m then 1%Z else 0%Z) *
      (fun m => 2 * Rabs (B tau m m)) m)) by (rewrite delta_sum; ring).
    rewrite <- total_plus. apply total_le. intros l. unfold part, off. destruct (decide i l) as [<-|Ne].
    - rewrite Hi, (proj2 (same_iff i i) eq_refl).
      replace (B tau i i + B tau i i) with (2 * B tau i i) by ring. rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
      replace (0 / cm) with 0 by (field; lra). lra.
    - rewrite (same_not i l Ne). rewrite Rmult_0_l, Rplus_0_r. destruct (lies bl j l); [|lra].
      apply scaled_up. rewrite !plus_IZR, abs_IZR, plus_IZR.
      assert (N1 := B_near tau i l Ht). assert (N2 := B_near tau l i Ht). unfold T, E in N1, N2. fold TT EE in N1, N2.
      rewrite <- (Rabs_pos_eq (det * pb)), <- Rabs_mult by lra.
      replace ((B tau i l + B tau l i) * (det * pb)) with (IZR (TT i l) + IZR (TT l i)
        + ((B tau i l * (det * pb) - IZR (TT i l)) + (B tau l i * (det * pb) - IZR (TT l i)))) by ring.
      eapply Rle_trans. apply Rabs_triang. apply Rplus_le_compat_l. apply Rabs_plus_le; auto. }
  rewrite (total_ext coordinates (fun l => part (lies bl) j (fun l => IZR (off l) / cm) l)
    (fun l => / cm * part (lies bl) j (fun l => IZR (off l)) l)), total_scal in X
    by (intros l; unfold part; destruct (lies bl j l); unfold Rdiv; ring).
  set (Y := total coordinates (fun l => part (lies bl) j (fun l => IZR (off l)) l)) in *.
  change (total coordinates (part (lies bl) j (fun i0 => IZR (off i0)))) with Y.
  apply (Rmult_le_compat_r cm) in X; [|lra].
  replace ((/ cm * Y + 2 * Rabs (B tau i i)) * cm) with (Y + 2 * Rabs (B tau i i) * cm) in X by (field; lra). lra. }
unfold Rdiv in *. rewrite Rmult_plus_distr_r. lra.
Qed.

Lemma entries_bounded j k : j <> k -> 0 <= IZR (M j k) / cm /\
  total coordinates (fun i => part (lies bl) j (fun i => total coordinates (fun l => part (lies bl) k (C i) l ^ 2)) i)
    <= (IZR (M j k) / cm) ^ 2.
Proof.
intros Ne. assert (K := cm_pos).
assert (H := every_true _ (every_true _ Hgrowth j) k). simpl in H. rewrite (same_not j k Ne) in H.
apply andb_true_iff in H. destruct H as [H1 H2]. apply Z.leb_le in H1, H2. apply IZR_le in H1, H2.
split. { apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, K. }
unfold squares in H2. fold bl in H2. rewrite sum_over_real, mult_IZR in H2.
apply Rmult_le_reg_r with (cm ^ 2). apply pow_lt, K.
replace ((IZR (M j k) / cm) ^ 2 * cm ^ 2) with (IZR (M j k) * IZR (M j k)) by (field; lra).
apply Rle_trans with (2 := H2). rewrite Rmult_comm, <- total_scal. right. apply total_ext. intros i.
unfold part at 1 3. destruct (lies bl j i); [|ring]. rewrite sum_over_real, <- total_scal. apply total_ext. intros l.
unfold part. destruct (lies bl k l); [|ring]. rewrite mult_IZR. unfold C. field. lra.
Qed.

Lemma push_bounded tau j : t0 <= tau <= t1 -> within coordinates (lies bl) j (fun l => push l tau) (IZR (d j) / un).
Proof.
intros Ht. assert (P := det_pos). assert (U := un_pos).
assert (H := every_true _ Hpush j). simpl in H. apply andb_true_iff in H. destruct H as [H1 H2].
apply Z.leb_le in H1, H2. apply IZR_le in H1, H2. fold bl in H2. rewrite sum_over_real, mult_IZR in H2.
apply within_sizes with (s := fun l => IZR (turned_defect defect c l) / un).
- intros l _. unfold push, turned_defect. rewrite stored_same, quotient_abs by auto.
  apply quotient_le; auto.
  apply Rle_trans with (IZR (sum (fun m => (Z.abs (inverse c l m) * defect m)%Z)) / un).
  + rewrite sum_real. eapply Rle_trans. apply total_abs.
    unfold Rdiv. rewrite Rmult_comm, <- total_scal. apply total_le. intros m.
    rewrite Rabs_mult, mult_IZR, abs_IZR. fold (inv l m).
    apply Rle_trans with (Rabs (inv l m) * (IZR (defect m) / un)).
    apply Rmult_le_compat_l. apply Rabs_pos. apply HD, Ht. right. field. lra.
  + assert (V := up_le (sum (fun m => (Z.abs (inverse c l m) * defect m)%Z)) (determinant c) Hdet). fold det in V.
    apply (Rmult_le_compat_r (/ un)) in V; [|apply Rlt_le, Rinv_0_lt_compat, U]. unfold Rdiv. lra.
- apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, U.
- apply Rmult_le_reg_r with (un ^ 2). apply pow_lt, U.
  replace ((IZR (d j) / un) ^ 2 * un ^ 2) with (IZR (d j) * IZR (d j)) by (field; lra).
  apply Rle_trans with (2 := H2). rewrite Rmult_comm, <- total_scal. right. apply total_ext. intros i.
  unfold part. destruct (lies bl j i); [|ring]. rewrite mult_IZR. field. lra.
Qed.

(** One of the K parts of the piece. Plan: from T = 0 to 1 the part is an equation z' = B z + D with all of it scaled
    by the length k; the bounds above, times k, are the hypotheses of [inner_rate] and [block_growth]. *)
Lemma one_part K (u v : vector Z) a : let k := (t1 - t0) / IZR K in (0 < K)%Z -> t0 <= a -> a + k <= t1 ->
  all_positive u = true -> all_positive v = true ->
  rises r s left_end c M d K u u v = true -> rises r s left_end c M d K u v v = true ->
  (forall j, within coordinates (lies bl) j (fun i => zeta i a) (IZR (u j) / un)) ->
  forall sigma, 0 <= sigma <= 1 -> forall j, within coordinates (lies bl) j (fun i => zeta i (a + k * sigma))
    (IZR (u j) / un + sigma * (IZR (v j) / un - IZR (u j) / un)).
Proof.
intros k HK Ha Hk Pu Pv Ru Rv Hs sigma Hsigma j.
assert (U := un_pos). assert (Cm := cm_pos). assert (Ct := ct_pos). assert (KR : 0 < IZR K) by (apply IZR_lt, HK).
assert (Long : 0 < t1 - t0).
{ unfold t0, t1. apply IZR_lt in Hends. assert (IZR left_end / ct < IZR (right_end c) / ct).
  { apply Rmult_lt_compat_r; auto. apply Rinv_0_lt_compat, Ct. } lra. }
assert (Kp : 0 < k) by (apply Rdiv_lt_0_compat; auto).
assert (Ah : 0 < k * (h / ct)) by (apply Rmult_lt_0_compat; auto; apply Rdiv_lt_0_compat; auto).
assert (In : forall t, 0 <= t <= 1 -> t0 <= a + k * t <= t1).
{ intros t Ht. assert (0 <= k * t) by (apply Rmult_le_pos; lra).
  assert (k * t <= k * 1) by (apply Rmult_le_compat_l; lra). lra. }
assert (Positive : forall w : vector Z, all_positive w = true -> forall j, 0 < IZR (w j) / un).
{ intros w Hw i. assert (H := every_true _ Hw i). apply Z.ltb_lt in H. apply Rdiv_lt_0_compat; auto. apply IZR_lt, H. }
assert (Rise : forall w : vector Z, rises r s left_end c M d K u w v = true -> forall j,
  total coordinates (fun l => k * (h / ct) * (IZR (M j l) / cm) * (IZR (w l) / un)) + k * (IZR (d j) / un)
    <= IZR (v j) / un - IZR (u j) / un).
{ intros w Hw i. assert (H := every_true _ Hw i). apply Z.leb_le in H. apply IZR_le in H.
  rewrite !mult_IZR, !minus_IZR, plus_IZR, !mult_IZR, sum_real in H.
  rewrite (total_ext coordinates (fun l => IZR (M i l * w l)) (fun l => IZR (M i l) * IZR (w l))) in H
    by (intros; apply mult_IZR).
  fold h ct cm in H. set (X := total coordinates (fun l => IZR (M i l) * IZR (w l))) in H.
  rewrite (total_ext coordinates _ (fun l => k * (h / ct) / cm / un * (IZR (M i l) * IZR (w l))))
    by (intros; field; lra). rewrite total_scal. fold X.
  assert (Ek : k = (IZR (right_end c) - IZR left_end) / (ct * IZR K)).
  { unfold k, t0, t1. field. lra. }
  rewrite Ek. apply Rmult_le_reg_r with (un * (IZR K * (cm * (ct * ct)))).
  { repeat apply Rmult_lt_0_compat; auto. }
  replace ((IZR (v i) / un - IZR (u i) / un) * (un * (IZR K * (cm * (ct * ct)))))
    with ((IZR (v i) - IZR (u i)) * (IZR K * (cm * (ct * ct)))) by (field; lra).
  eapply Rle_trans; [|exact H]. right. field. lra. }
change (IZR (u j) / un + sigma * (IZR (v j) / un - IZR (u j) / un))
  with (bound (fun j => IZR (u j) / un) (fun j => IZR (v j) / un) j sigma).
apply (block_growth coordinates (lies bl) every_coordinate (fun i t => zeta i (a + k * t))
  (fun i t => k * (h / ct * total coordinates (fun q => B (a + k * t) i q * zeta q (a + k * t)) + push i (a + k * t)))
  (fun j l => k * (h / ct) * (IZR (M j l) / cm)) (fun j => k * (IZR (d j) / un))).
- apply Positive, Pu.
- apply Positive, Pv.
- intros i t Ht. eapply is_derive_val.
  + apply (is_derive_comp (zeta i) (fun t => a + k * t) t
      (h / ct * total coordinates (fun q => B (a + k * t) i q * zeta q (a + k * t)) + push i (a + k * t)) k).
    apply zeta_derive, In, Ht. auto_derive; auto. ring.
  + reflexivity.
- intros t Ht w Hw i Hi. set (tau := a + k * t).
  assert (Ht' := In t Ht). fold tau in Ht'.
  rewrite (total_ext coordinates _ (fun l => part (lies bl) i (fun l => zeta l tau) l * part (lies bl) i (fun l =>
    total coordinates (fun q => k * (h / ct) * B tau l q * zeta q tau) + k * push l tau) l)).
  2: { intros l. f_equal. unfold part. destruct (lies bl i l); auto. fold tau.
    rewrite (total_ext coordinates (fun q => k * (h / ct) * B tau l q * zeta q tau)
      (fun q => k * (h / ct) * (B tau l q * zeta q tau))) by (intros; ring).
    rewrite total_scal. ring. }
  apply (inner_rate coordinates (lies bl) every_coordinate (lies_parts bl)
    (fun l q => k * (h / ct) * B tau l q) (fun l q => k * (h / ct) * C l q)
    (fun j l => k * (h / ct) * (IZR (M j l) / cm)) (fun j => k * (IZR (d j) / un)) w
    (fun l => zeta l tau) (fun l => k * push l tau) i (decide i)); auto.
  + intros l q. rewrite Rabs_mult, (Rabs_pos_eq (k * (h / ct))) by lra. apply Rmult_le_compat_l. lra.
    apply B_size, Ht'.
  + intros l Hl. assert (Q := diagonal_bounded tau i l Ht' Hl).
    rewrite Rabs_mult, (Rabs_pos_eq (k * (h / ct))) by lra.
    rewrite (total_ext coordinates _ (fun q => k * (h / ct) * part (lies bl) i (fun q =>
      Rabs (B tau l q + B tau q l)) q)).
    2: { intros q. unfold part. destruct (lies bl i q); [|ring].
      rewrite <- Rmult_plus_distr_l, Rabs_mult, (Rabs_pos_eq (k * (h / ct))) by lra. reflexivity. }
    rewrite total_scal. apply (Rmult_le_compat_l (k * (h / ct))) in Q; lra.
  + intros l Hl. destruct (entries_bounded i l Hl) as [Q0 Q]. split. { apply Rmult_le_pos; auto. lra. }
    rewrite Rpow_mult_distr. apply (Rmult_le_compat_l ((k * (h / ct)) ^ 2)) in Q; [|apply pow2_ge_0].
    eapply Rle_trans; [|exact Q]. right. rewrite <- total_scal. apply total_ext. intros q.
    unfold part at 1 3. destruct (lies bl i q); [|ring]. rewrite <- total_scal. apply total_ext. intros n.
    unfold part. destruct (lies bl l n); ring.
  + assert (Q := push_bounded tau i Ht'). destruct Q as [Q0 Q]. split. { apply Rmult_le_pos; auto; lra. }
    unfold square. rewrite (total_ext coordinates _ (fun l => k ^ 2 * part (lies bl) i (fun l => push l tau) l ^ 2)).
    * rewrite total_scal, Rpow_mult_distr. apply Rmult_le_compat_l. apply pow2_ge_0. exact Q.
    * intros l. unfold part. destruct (lies bl i l); ring.
- apply Rise, Ru.
- apply Rise, Rv.
- intros l. apply within_ext with (2 := Hs l). intros i. rewrite Rmult_0_r, Rplus_0_r. reflexivity.
- exact Hsigma.
Qed.

Lemma within_bigger j z (x y : Z) : (x <= y)%Z -> within coordinates (lies bl) j z (IZR x / un) ->
  within coordinates (lies bl) j z (IZR y / un).
Proof.
intros H. apply within_le. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, un_pos. apply IZR_le, H.
Qed.

Lemma highest_first (rest : list (vector Z)) : forall u j, (u j <= highest u rest j)%Z.
Proof. induction rest as [|v rest IH]; intros u j; cbn [highest]; [lia|rewrite stored_same; lia]. Qed.

(** The nodes one after the other. *)
Lemma nodes_sound K : (0 < K)%Z -> forall rest u a, t0 <= a ->
  a + INR (length rest) * ((t1 - t0) / IZR K) = t1 -> majorant r s left_end c M d K u rest = true ->
  (forall j, within coordinates (lies bl) j (fun i => zeta i a) (IZR (u j) / un)) ->
  (forall tau, a <= tau <= t1 -> forall j,
    within coordinates (lies bl) j (fun i => zeta i tau) (IZR (highest u rest j) / un)) /\
  (forall j, within coordinates (lies bl) j (fun i => zeta i t1) (IZR (final u rest j) / un)).
Proof.
intros HK. set (k := (t1 - t0) / IZR K). assert (KR : 0 < IZR K) by (apply IZR_lt, HK).
assert (Ct := ct_pos). assert (U := un_pos).
assert (Kp : 0 < k).
{ apply Rdiv_lt_0_compat; auto. unfold t0, t1. apply IZR_lt in Hends.
  assert (IZR left_end / ct < IZR (right_end c) / ct).
  { apply Rmult_lt_compat_r; auto. apply Rinv_0_lt_compat, Ct. } lra. }
induction rest as [|v rest IH]; intros u a Ha El Hm Hs.
- simpl in El. split.
  + intros tau Ht j. replace tau with a by lra. apply Hs.
  + intros j. replace t1 with a by lra. apply Hs.
- cbn [majorant] in Hm. rewrite !andb_true_iff in Hm. destruct Hm as (((P & R1) & R2) & Hm).
  change (length (v :: rest)) with (Datatypes.S (length rest)) in El. rewrite S_INR in El.
  assert (L0 := pos_INR (length rest)). assert (L1 : 0 <= INR (length rest) * k) by (apply Rmult_le_pos; lra).
  assert (Pv : all_positive v = true).
  { destruct rest; cbn [majorant] in Hm. exact Hm. rewrite !andb_true_iff in Hm. tauto. }
  assert (One := one_part K u v a HK Ha ltac:(fold k; lra) P Pv R1 R2 Hs). cbv zeta in One. fold k in One.
  assert (End : forall j, within coordinates (lies bl) j (fun i => zeta i (a + k)) (IZR (v j) / un)).
  { intros j. assert (Q := One 1 ltac:(lra) j). rewrite Rmult_1_r in Q.
    replace (IZR (u j) / un + 1 * (IZR (v j) / un - IZR (u j) / un)) with (IZR (v j) / un) in Q by ring. exact Q. }
  destruct (IH v (a + k) ltac:(lra) ltac:(lra) Hm End) as [I1 I2]. split; [|exact I2].
  intros tau Ht j. cbn [highest]. rewrite stored_same. destruct (Rle_dec tau (a + k)) as [Hle|Hgt].
  + assert (Si : 0 <= (tau - a) / k <= 1).
    { split. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, Kp. apply quotient_le; lra. }
    assert (Q := One ((tau - a) / k) Si j).
    replace (a + k * ((tau - a) / k)) with tau in Q by (field; lra).
    apply within_le with (2 := Q). set (x := (tau - a) / k) in *.
    assert (M1 : IZR (u j) / un <= IZR (Z.max (u j) (highest v rest j)) / un).
    { apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, U. apply IZR_le. lia. }
    assert (M2 : IZR (v j) / un <= IZR (Z.max (u j) (highest v rest j)) / un).
    { apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, U. apply IZR_le.
      assert (HF := highest_first rest v j). lia. }
    assert (A1 := Rmult_le_compat_l (1 - x) _ _ ltac:(lra) M1).
    assert (A2 := Rmult_le_compat_l x _ _ ltac:(lra) M2). lra.
  + apply within_bigger with (2 := I1 tau ltac:(lra) j). lia.
Qed.

(** ** The start of the piece, and the whole of it *)
Variables (N' : matrix) (dj u : vector Z) (rest : list (vector Z)).
Hypothesis Hnorms : norms_bounded r before c (change before c) N' = true.
Hypothesis Hjump : lengths_bounded c (turned_jump jump c) dj = true.
Hypothesis Hentered : entered r before N' dj u = true.
Hypothesis Hparts : (0 < Z.of_nat (length rest))%Z.
Hypothesis Hmajorant : majorant r s left_end c M d (Z.of_nat (length rest)) u rest = true.

Lemma jump_bounded j : within coordinates (lies bl) j
  (fun l => total coordinates (fun m => inv l m * (IZR (jump m) / un)) / det) (IZR (dj j) / un).
Proof.
assert (P := det_pos). assert (U := un_pos).
assert (H := every_true _ Hjump j). simpl in H. apply andb_true_iff in H. destruct H as [H1 H2].
apply Z.leb_le in H1, H2. apply IZR_le in H1, H2. fold bl in H2. rewrite sum_over_real, mult_IZR in H2.
apply within_sizes with (s := fun l => IZR (turned_jump jump c l) / un).
- intros l _. unfold turned_jump. rewrite stored_same, quotient_abs by auto. apply quotient_le; auto.
  assert (V := up_le (Z.abs (sum (fun m => (inverse c l m * jump m)%Z))) (determinant c) Hdet). fold det in V.
  rewrite abs_IZR, sum_real in V.
  rewrite (total_ext coordinates _ (fun m => / un * IZR (inverse c l m * jump m))).
  2: { intros m. rewrite mult_IZR. unfold inv. field. lra. }
  rewrite total_scal, Rabs_mult, (Rabs_pos_eq (/ un)) by (apply Rlt_le, Rinv_0_lt_compat, U).
  apply (Rmult_le_compat_l (/ un)) in V; [|apply Rlt_le, Rinv_0_lt_compat, U]. unfold Rdiv. lra.
- apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, U.
- apply Rmult_le_reg_r with (un ^ 2). apply pow_lt, U.
  replace ((IZR (dj j) / un) ^ 2 * un ^ 2) with (IZR (dj j) * IZR (dj j)) by (field; lra).
  apply Rle_trans with (2 := H2). rewrite Rmult_comm, <- total_scal. right. apply total_ext. intros i.
  unfold part. destruct (lies bl j i); [|ring]. rewrite mult_IZR. field. lra.
Qed.

Lemma change_bounded j k : 0 <= IZR (N' j k) / cm /\ forall a, lies (its_blocks before) k a = true ->
  total coordinates (part (lies (its_blocks before)) k (fun b => Rabs (total coordinates (part (lies bl) j
    (fun i => IZR (change before c i a) / det * (IZR (change before c i b) / det)))))) <= (IZR (N' j k) / cm) ^ 2.
Proof.
assert (P := det_pos). assert (K := cm_pos).
assert (H := every_true _ (every_true _ Hnorms j) k). simpl in H. apply andb_true_iff in H. destruct H as [H1 H2].
apply Z.leb_le in H1. apply IZR_le in H1. split. { apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat, K. }
intros a Ha. assert (H := every_true _ H2 a). simpl in H. rewrite Ha in H. simpl in H. apply Z.leb_le in H.
apply IZR_le in H. unfold gram_sum in H. fold bl in H. rewrite !mult_IZR, sum_over_real in H. fold cm det in H.
apply Rmult_le_reg_r with (cm * cm * (det * det)). { repeat apply Rmult_lt_0_compat; auto. }
replace ((IZR (N' j k) / cm) ^ 2 * (cm * cm * (det * det))) with (IZR (N' j k) * IZR (N' j k) * (det * det))
  by (field; lra).
eapply Rle_trans; [|exact H]. right.
replace (cm * cm * (det * det)) with ((cm * cm) * (det * det)) by ring.
rewrite Rmult_comm, Rmult_assoc, <- total_scal. f_equal. apply total_ext. intros b. unfold part at 1 3.
destruct (lies (its_blocks before) k b); [|ring].
rewrite abs_IZR, sum_over_real, <- (Rabs_pos_eq (det * det)), <- Rabs_mult by (apply Rmult_le_pos; lra).
f_equal. rewrite <- total_scal. apply total_ext. intros i. unfold part. destruct (lies bl j i); [|ring].
rewrite mult_IZR. field. lra.
Qed.

Lemma entered_right j : within coordinates (lies bl) j (fun l => zeta l t0) (IZR (u j) / un).
Proof.
assert (P := det_pos). assert (K := cm_pos). assert (U := un_pos).
destruct Hbefore as (z & Ez & Wz).
set (G := fun l n => IZR (change before c l n) / det).
apply within_ext with (v := fun l => total coordinates (fun k => total coordinates (fun n =>
  G l n * part (lies (its_blocks before)) k z n)) + total coordinates (fun m => inv l m * (IZR (jump m) / un)) / det).
- intros l. rewrite (by_blocks coordinates (lies (its_blocks before)) (lies_parts (its_blocks before)) G z l).
  unfold zeta.
  rewrite (total_ext coordinates (fun m => inv l m * e m t0) (fun m => inv l m * total coordinates (fun n =>
    IZR (its_basis before m n) * z n) + inv l m * (IZR (jump m) / un))).
  2: { intros m. rewrite <- Ez. ring. }
  rewrite total_plus, double_sum. unfold Rdiv at 3. rewrite Rmult_plus_distr_r. f_equal.
  rewrite Rmult_comm, <- total_scal. apply total_ext. intros n. unfold G, change. cbv zeta.
  rewrite !stored_same, sum_real.
  rewrite (total_ext coordinates (fun m => IZR (inverse c l m * its_basis before m n))
    (fun m => inv l m * IZR (its_basis before m n))) by (intros; apply mult_IZR). field. lra.
- apply within_le with (total coordinates (fun k => IZR (N' j k) / cm * (IZR (radii before k) / un))
    + IZR (dj j) / un).
  + assert (H := every_true _ Hentered j). apply Z.leb_le in H. apply IZR_le in H.
    rewrite plus_IZR, sum_real, !mult_IZR in H. fold cm in H.
    rewrite (total_ext coordinates _ (fun k => / cm / un * IZR (N' j k * radii before k))).
    2: { intros k. rewrite mult_IZR. field. lra. }
    rewrite total_scal. apply Rmult_le_reg_r with (cm * un). { apply Rmult_lt_0_compat; auto. }
    replace (IZR (u j) / un * (cm * un)) with (IZR (u j) * cm) by (field; lra).
    eapply Rle_trans; [|exact H]. right. field. lra.
  + apply within_plus; [|apply jump_bounded].
    apply (within_total coordinates (lies bl) j coordinates (fun k l => total coordinates (fun n =>
      G l n * part (lies (its_blocks before)) k z n))). intros k.
    destruct (change_bounded j k) as [C0 CB].
    apply (within_gram coordinates (lies bl) (lies (its_blocks before)) j k G z); auto.
Qed.

Lemma accepted_piece : (forall tau, t0 <= tau <= t1 -> forall i, Rabs (e i tau) <= IZR (reach c (highest u rest) i) /
  un)
  /\ near (Errors (basis c) bl (final u rest)) (fun i => e i t1).
Proof.
assert (U := un_pos). assert (Ct := ct_pos). assert (KR : 0 < IZR (Z.of_nat (length rest))) by (apply IZR_lt, Hparts).
destruct (nodes_sound (Z.of_nat (length rest)) Hparts rest u t0 ltac:(lra)) as [H1 H2]; auto using entered_right.
{ rewrite INR_IZR_INZ. field. lra. }
split.
- intros tau Ht i. rewrite errors_are. unfold reach. rewrite stored_same, sum_real.
  eapply Rle_trans. apply total_abs. unfold Rdiv. rewrite Rmult_comm, <- total_scal. apply total_le. intros l.
  rewrite mult_IZR, abs_IZR, Rabs_mult. fold (S i l).
  apply Rle_trans with (Rabs (S i l) * (IZR (highest u rest (bl l)) / un)); [|right; unfold Rdiv, S, bl; ring].
  apply Rmult_le_compat_l. apply Rabs_pos.
  apply (within_component coordinates (lies bl) (bl l) (fun i => zeta i tau)). apply every_coordinate.
  unfold lies. apply same_iff. reflexivity. apply H1, Ht.
- exists (fun l => zeta l t1). split; [|exact H2]. intros i. apply errors_are.
Qed.

End Piece.

(** ** One step *)
Let gr := IZR (grain r).
Lemma gr_pos : 0 < gr. Proof. apply IZR_lt, Hgrain. Qed.
Lemma un_is : un = gr * IZR (fine r). Proof. unfold un, unit. apply mult_IZR. Qed.
Lemma fine_pos : 0 < IZR (fine r). Proof. apply IZR_lt, Hfine. Qed.

Definition forcing (i : coordinate) : R := match i with of_b => IZR (rate2 (its_rates r)) / N | _ => 0 end.
Definition x (i : coordinate) (tau : R) : R := value tau (curve s i) / gr.

Variable U : coordinate -> R -> R.
Hypothesis HU : forall i tau,
  is_derive (U i) tau (h / ct * (total coordinates (fun l => equations (p_at tau) i l * U l tau) + forcing i)).

Definition rest (i : coordinate) (tau : R) : R :=
  h / ct * (total coordinates (fun l => equations (p_at tau) i l * x l tau) + forcing i)
    - value tau (derivative (curve s i)) / gr.

Lemma error_derive i tau : is_derive (fun t => U i t - x i t) tau
  (h / ct * total coordinates (fun l => equations (p_at tau) i l * (U l tau - x l tau)) + rest i tau).
Proof.
assert (G := gr_pos). assert (Ct := ct_pos).
apply (is_derive_val _ _ (h / ct * (total coordinates (fun l => equations (p_at tau) i l * U l tau) + forcing i)
  - / gr * value tau (derivative (curve s i)))).
- apply (is_derive_minus (U i) (x i)); [apply HU|].
  apply (is_derive_ext (fun t => / gr * value t (curve s i))). { intros t. change (/ gr * value t (curve s i) = value
    t (curve s i) / gr). field. lra. }
  apply (is_derive_scal (fun t => value t (curve s i)) tau (/ gr)), value_derive.
- unfold rest, total, coordinates; cbn [fold_right]. field. lra.
Qed.

Lemma residual_bound (p : poly) tau (f : Z) y : 0 <= tau <= 1 -> (0 < f)%Z -> value tau p = y * (IZR f * gr) ->
  Rabs y <= IZR (up (poly_norm p * fine r) f) / un.
Proof.
intros Ht Hf Hy. assert (G := gr_pos). assert (Fp := fine_pos). assert (F : 0 < IZR f) by (apply IZR_lt, Hf).
assert (V := value_norm tau ltac:(apply Rabs_le; lra) p). rewrite Hy, Rabs_mult in V.
rewrite (Rabs_pos_eq (IZR f * gr)) in V by (apply Rmult_le_pos; lra).
assert (Q := up_le (poly_norm p * fine r) f Hf). rewrite mult_IZR in Q.
rewrite un_is. apply Rmult_le_reg_r with (gr * IZR (fine r) * IZR f). { repeat apply Rmult_lt_0_compat; auto. }
replace (IZR (up (poly_norm p * fine r) f) / (gr * IZR (fine r)) * (gr * IZR (fine r) * IZR f))
  with (IZR f * IZR (up (poly_norm p * fine r) f)) by (field; lra).
apply Rle_trans with (2 := Q).
replace (Rabs y * (gr * IZR (fine r) * IZR f)) with (Rabs y * (IZR f * gr) * IZR (fine r)) by ring.
apply Rmult_le_compat_r; lra.
Qed.

Lemma defect_right i tau : 0 <= tau <= 1 -> Rabs (rest i tau) <= IZR (defects r begin s i) / un.
Proof.
intros Ht. assert (G := gr_pos). assert (Ct := ct_pos). assert (NP := N_pos).
unfold defects. rewrite stored_same.
assert (BC : (0 < below (its_rates r) * clock r)%Z) by (apply Z.mul_pos_pos; auto).
destruct i; cbn [row].
- apply residual_bound with (tau := tau); auto. unfold residual_b, force.
  rewrite ?value_minus, ?value_times, ?value_minus, ?value_times. cbn [value].
  rewrite ?value_minus, ?mult_IZR. unfold rest, x, forcing, total, coordinates. cbn [fold_right equations].
  fold h ct N gr. field. lra.
- apply residual_bound with (tau := tau); auto. unfold residual_y.
  rewrite ?value_minus, ?value_times. unfold rest, x, forcing, total, coordinates. cbn [fold_right equations].
  fold h ct N gr. field. lra.
- apply residual_bound with (tau := tau); auto. { apply Z.mul_pos_pos; auto. } unfold residual_v, force.
  rewrite ?value_minus, ?value_times, ?value_plus, ?value_times, ?value_linear, ?value_minus, ?mult_IZR.
  unfold rest, x, forcing, total, coordinates. cbn [fold_right equations]. unfold p_at.
  fold h ct N gr. field. lra.
- apply residual_bound with (tau := tau); auto. unfold residual_z.
  rewrite ?value_minus, ?value_times, ?value_minus, ?value_times.
  unfold rest, x, forcing, total, coordinates. cbn [fold_right equations]. fold h ct N gr. field. lra.
Qed.

Let err (i : coordinate) (tau : R) : R := U i tau - x i tau.

Lemma all_pieces_sound : forall l left_end before jump tube after w,
  all_pieces r begin s (defects r begin s) left_end before jump tube l = Some (after, w) ->
  (0 <= left_end)%Z -> near before (fun i => err i (IZR left_end / ct) - IZR (jump i) / un) ->
  left_end = 0%Z \/ ((forall i, jump i = 0%Z) /\
    forall tau, 0 <= tau <= IZR left_end / ct -> forall i, Rabs (err i tau) <= IZR (tube i) / un) ->
  near after (fun i => err i 1) /\ forall tau, 0 <= tau <= 1 -> forall i, Rabs (err i tau) <= IZR (w i) / un.
Proof.
assert (Ct := ct_pos). assert (UP := un_pos).
induction l as [|c l IH]; intros left_end before jump tube after w H H0 Hn Ht; cbn [all_pieces] in H.
- destruct (left_end =? clock r)%Z eqn:E; [|discriminate]. apply Z.eqb_eq in E. injection H as <- <-.
  destruct Ht as [Zero|[J T]]; [lia|].
  assert (One : IZR left_end / ct = 1). { rewrite E. fold ct. field. lra. }
  rewrite One in *. split; auto. destruct Hn as (z & E1 & E2). exists z. split; auto. intros i.
  rewrite <- E1, J. field. lra.
- destruct (one_piece r begin s (defects r begin s) left_end before jump c) as [[after' w']|] eqn:P; [|discriminate].
  destruct (right_end c <=? clock r)%Z eqn:Far; [|discriminate]. apply Z.leb_le in Far.
  unfold one_piece in P. destruct (nodes c) as [|u rest']; [discriminate|]. cbv zeta in P.
  match type of P with (if ?b then _ else _) = _ => destruct b eqn:Eb; [|discriminate] end.
  injection P as <- <-. rewrite !andb_true_iff in Eb.
  destruct Eb as (((((((((C1 & C2) & C3) & C4) & C5) & C6) & C7) & C8) & C9) & C10).
  apply Z.ltb_lt in C1, C2, C3.
  assert (L0 : 0 <= IZR left_end / ct). { apply Rmult_le_pos. apply IZR_le, H0. apply Rlt_le, Rinv_0_lt_compat, Ct. }
  assert (L1 : IZR (right_end c) / ct <= 1). { apply quotient_le; auto. rewrite Rmult_1_l. apply IZR_le, Far. }
  destruct (accepted_piece (defects r begin s) left_end before jump c err rest C1 C3 C4
    (fun i tau _ => error_derive i tau) (fun i tau Ht' => defect_right i tau ltac:(lra)) Hn _ _ C5 C6 _ _ u rest'
    C8 C7 C9 C2 C10) as [A1 A2].
  apply (IH (right_end c) _ _ _ after w H).
  + lia.
  + destruct A2 as (z & E1 & E2). exists z. split; auto. intros i. rewrite <- E1.
    replace (IZR (no_jump i)) with 0 by (destruct i; reflexivity). field. lra.
  + right. split. { intros i. destruct i; reflexivity. }
    intros tau Hr i. rewrite stored_same. destruct (Rle_dec (IZR left_end / ct) tau) as [Hle|Hgt].
    * apply Rle_trans with (1 := A1 tau ltac:(lra) i). apply Rmult_le_compat_r.
      apply Rlt_le, Rinv_0_lt_compat, UP. apply IZR_le. lia.
    * destruct Ht as [Zero|[_ T]]. { rewrite Zero in Hgt. unfold Rdiv in Hgt. lra. }
      apply Rle_trans with (1 := T tau ltac:(lra) i). apply Rmult_le_compat_r.
      apply Rlt_le, Rinv_0_lt_compat, UP. apply IZR_le. lia.
Qed.

Lemma one_step_sound before middle after tube : one_step r begin s before middle = Some (after, tube) ->
  near before (fun i => U i 0 - IZR (middle i) / gr) ->
  near after (fun i => U i 1 - IZR (end_of s i) / gr) /\
    forall tau, 0 <= tau <= 1 -> forall i, Rabs (U i tau - x i tau) <= IZR (tube i) / un.
Proof.
intros H Hn. unfold one_step in H. cbv zeta in H. destruct (0 <? duration s)%Z; [|discriminate].
assert (Ct := ct_pos). assert (G := gr_pos). assert (Fp := fine_pos).
destruct (all_pieces_sound (pieces s) 0 before _ no_jump after tube H) as [A1 A2]; auto. lia.
- destruct Hn as (z & E1 & E2). exists z. split; auto. intros i. rewrite <- E1. unfold err, x.
  rewrite !stored_same, mult_IZR, minus_IZR. unfold start_of. rewrite stored_same, un_is.
  replace (0 / ct) with 0 by (field; lra).
  assert (V : value 0 (curve s i) = IZR (hd 0%Z (curve s i))). { destruct (curve s i); simpl; ring. }
  rewrite V. field. lra.
- split; auto. destruct A1 as (z & E1 & E2). exists z. split; auto. intros i. rewrite <- E1. unfold err, x.
  unfold end_of. rewrite stored_same.
  assert (V : forall p, value 1 p = IZR (fold_right Z.add 0%Z p)).
  { induction p as [|a p IH]; simpl; auto. rewrite IH, plus_IZR. ring. }
  rewrite V. reflexivity.
Qed.

End Step.
End Run.
