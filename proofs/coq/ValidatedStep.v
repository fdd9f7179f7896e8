(** * One validated step: V1 and V3 of proofs/validated_step.md

    The difference of a solution and the approximation solves a linear equation as long as the solution is in the box:
    by the mean value theorem, component by component ([field_difference]). [logarithmic_growth] bounds it
    ([tube_kept]). A solution exists since f, read off at the nearest point of the box, is Lipschitz on the whole space
    ([InitialValueProblem]); it stays in the tube, where nothing is changed. *)

From Coq Require Import Reals Psatz Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus InitialValueProblem LogarithmicNorm StatementStep.
Import ListNotations.
Open Scope R_scope.

Section Step.
Variables (I : Type) (all : list I) (f : I -> (I -> R) -> R) (J : I -> I -> (I -> R) -> R) (low high w : I -> R).
Variables (x x' : I -> R -> R) (h mu delta e0 radius r : R).
Hypothesis Hall : forall i, In i all.
Hypothesis Hstep : step_checked all f J low high w x x' h mu delta e0 radius r.

(** The mean value theorem between two points of the box. *)
Lemma field_difference v v' i : in_box low high v -> in_box low high v' ->
  exists p, (forall j, Rmin (v j) (v' j) <= p j <= Rmax (v j) (v' j)) /\ in_box low high p /\
    f i v' - f i v = total all (fun j => J i j p * (v' j - v j)).
Proof.
intros Hv Hv'.
set (p := fun s j => v j + s * (v' j - v j)).
assert (Between : forall s, 0 <= s <= 1 -> forall j, Rmin (v j) (v' j) <= p s j <= Rmax (v j) (v' j)).
{ intros s Hs j. unfold p, Rmin, Rmax. destruct Rle_dec; split; nra. }
assert (Inside : forall s, 0 <= s <= 1 -> in_box low high (p s)).
{ intros s Hs j. specialize (Between s Hs j). specialize (Hv j). specialize (Hv' j).
  unfold Rmin, Rmax in Between. destruct Rle_dec; lra. }
assert (D : forall s, 0 <= s <= 1 -> is_derive (fun s => f i (p s)) s
  (total all (fun j => J i j (p s) * (v' j - v j)))).
{ intros s Hs. assert (G := derivatives _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep (p s) (Inside s Hs) i (fun j => v' j - v j)).
  apply (is_derive_ext (fun t => (fun u => f i (fun j => p s j + u * (v' j - v j))) (t - s))).
  { intros t. apply (f_equal (f i)), functional_extensionality. intros j. unfold p. ring. }
  eapply is_derive_val.
  - apply (is_derive_comp (fun u => f i (fun j => p s j + u * (v' j - v j))) (fun t => t - s)).
    + rewrite Rminus_eq_0. exact G.
    + auto_derive; auto.
  - unfold scal; simpl; unfold mult; simpl. ring. }
destruct (mvt_open (fun s => f i (p s)) _ 0 1 ltac:(lra) D) as (c & Hc & E).
exists (p c). refine (conj (Between c ltac:(lra)) (conj (Inside c ltac:(lra)) _)).
assert (P0 : p 0 = v) by (apply functional_extensionality; intros j; unfold p; ring).
assert (P1 : p 1 = v') by (apply functional_extensionality; intros j; unfold p; ring).
rewrite P0, P1 in E. rewrite E. ring.
Qed.
Let k := Rmax (h * mu) 0.

Lemma growth_nonneg : 0 <= k.
Proof. apply Rmax_r. Qed.

Lemma weight i : 0 < w i.
Proof. apply (positive_weights _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep). Qed.

Lemma length_pos : 0 < h.
Proof. apply (positive_length _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep). Qed.

Lemma near_inside v t : 0 <= t <= 1 -> norm_at_most w (fun i => v i - x i t) radius -> in_box low high v.
Proof. intros Ht. apply (inside _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep t Ht). Qed.

(** The field read off at the nearest point of the box. *)
Definition nearest (v : I -> R) (j : I) : R := Rmax (low j) (Rmin (v j) (high j)).

Lemma nearest_inside v : in_box low high v -> nearest v = v.
Proof.
intros Hv. apply functional_extensionality. intros j. specialize (Hv j). unfold nearest.
rewrite Rmin_left by lra. apply Rmax_right. lra.
Qed.

Section Start.
Variable start : I -> R.
Hypothesis Hstart : norm_at_most w (fun i => start i - x i 0) e0.

(** Both e0 and delta are bounds of sizes. *)
Lemma bounds_nonneg : I -> 0 <= e0 /\ 0 <= delta.
Proof.
intros i. assert (W := weight i). assert (S := Hstart i).
assert (D := defect _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep 0 ltac:(lra) i). simpl in S, D.
split; (apply Rmult_le_reg_r with (w i); [exact W|rewrite Rmult_0_l; eapply Rle_trans; [apply Rabs_pos|eassumption]]).
Qed.

Lemma approximation_inside t : 0 <= t <= 1 -> in_box low high (fun j => x j t).
Proof.
intros Ht i. destruct (bounds_nonneg i) as [E D]. assert (G := tube _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
assert (N := narrow _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
assert (P : 0 <= r) by (rewrite G; apply Rmult_le_pos; [apply Rlt_le, exp_pos|lra]).
apply (near_inside (fun j => x j t) t Ht). intros j. unfold Rminus. rewrite Rplus_opp_r, Rabs_R0.
apply Rmult_le_pos. lra. apply Rlt_le, weight.
Qed.

Lemma nearest_in_box v : in_box low high (nearest v).
Proof.
intros j. assert (B := approximation_inside 0 ltac:(lra) j). simpl in B. unfold nearest. split. apply Rmax_l.
apply Rmax_lub. lra. apply Rmin_r.
Qed.

(** Whatever moves as f says within the box, and starts there, stays in the tube. *)
Lemma tube_kept T (xi rate : I -> R -> R) : 0 <= T <= 1 -> (forall i, xi i 0 = start i) ->
  (forall i t, 0 <= t <= T -> is_derive (xi i) t (rate i t)) ->
  (forall i t, 0 <= t <= T -> in_box low high (fun j => xi j t) -> rate i t = h * f i (fun j => xi j t)) ->
  forall t, 0 <= t <= T -> norm_at_most w (fun i => xi i t - x i t) r.
Proof.
intros HT H0 D E t Ht i. destruct (bounds_nonneg i) as [He Hd].
assert (Hk := growth_nonneg). assert (Hh := length_pos).
assert (G := tube _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep). assert (N := narrow _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
fold k in G.
assert (Le : forall s, 0 <= s <= 1 -> exp (k * s) * (e0 + delta * s) <= r).
{ intros s Hs. rewrite G. apply Rmult_le_compat.
  - apply Rlt_le, exp_pos.
  - assert (0 <= delta * s) by (apply Rmult_le_pos; lra). lra.
  - apply exp_le. rewrite <- (Rmult_1_r k) at 2. apply Rmult_le_compat_l; lra.
  - assert (delta * s <= delta * 1) by (apply Rmult_le_compat_l; lra). lra. }
assert (L := logarithmic_growth I all Hall w (fun i t => xi i t - x i t) (fun i t => rate i t - x' i t)
  k delta e0 radius T weight Hk Hd).
eapply Rle_trans; [apply L; clear L|].
- intros j s Hs. apply (is_derive_minus (xi j) (x j)). apply D, Hs.
  apply (approximation _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep). lra.
- intros s Hs B j.
  assert (Bx := near_inside (fun j => xi j s) s ltac:(lra) B).
  destruct (field_difference (fun j => x j s) (fun j => xi j s) j (approximation_inside s ltac:(lra)) Bx)
    as (p & _ & Hp & M).
  exists (fun l => h * J j l p), (h * f j (fun l => x l s) - x' j s). repeat split.
  + rewrite E by auto. rewrite (total_ext all _ (fun l => h * (J j l p * (xi l s - x l s)))) by (intros; ring).
    rewrite total_scal, <- M. ring.
  + rewrite Rabs_mult, (Rabs_pos_eq h) by lra.
    rewrite (total_ext all _ (fun l => h * (Rabs (J j l p) * (w l / w j)))).
    2: { intros l. rewrite Rabs_mult, (Rabs_pos_eq h) by lra. ring. }
    rewrite total_scal. apply Rle_trans with (2 := Rmax_l (h * mu) 0).
    assert (Gr := growth _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep p Hp j). simpl in Gr.
    apply (Rmult_le_compat_l h) in Gr; lra.
  + apply (defect _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep s). lra.
- intros j. rewrite H0. apply Hstart.
- apply Rle_lt_trans with r; auto.
- exact Ht.
- apply Rmult_le_compat_r. apply Rlt_le, weight. apply Le. lra.
Qed.

Lemma nearest_moves_less v v' j c : Rabs (v j - v' j) <= c -> Rabs (nearest v j - nearest v' j) <= c.
Proof.
intros H. assert (B := approximation_inside 0 ltac:(lra) j). simpl in B. revert H.
unfold nearest, Rmax, Rmin. repeat destruct Rle_dec; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma nearest_lipschitz : exists L, 0 <= L /\ forall v v' c, (forall j, Rabs (v j - v' j) <= c) ->
  forall i, Rabs (h * f i (nearest v) - h * f i (nearest v')) <= L * c.
Proof.
destruct (bounded _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep) as (M & HM). assert (Hh := length_pos).
exists (h * (INR (length all) * Rabs M)). split.
{ apply Rmult_le_pos. lra. apply Rmult_le_pos. apply pos_INR. apply Rabs_pos. }
intros v v' c Hc i.
destruct (field_difference (nearest v') (nearest v) i (nearest_in_box v') (nearest_in_box v)) as (p & _ & Hp & E).
rewrite <- Rmult_minus_distr_l, E, Rabs_mult, (Rabs_pos_eq h) by lra. rewrite Rmult_assoc. apply Rmult_le_compat_l. lra.
eapply Rle_trans. apply total_abs. rewrite Rmult_assoc, <- total_const. apply total_le.
intros j. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos.
- apply Rle_trans with (1 := HM p Hp i j), Rle_abs.
- apply nearest_moves_less, Hc.
Qed.

Lemma nearest_continuous (y : I -> R -> R) : (forall i t, continuous (y i) t) ->
  forall i t, continuous (fun s => h * f i (nearest (fun j => y j s))) t.
Proof.
intros Hy i t. destruct nearest_lipschitz as (L & HL & HLip).
apply filterlim_locally. intros eta.
assert (Hd : 0 < eta / (L + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos|lra]).
assert (Near : locally t (fun s => forall j, In j all -> Rabs (y j s - y j t) <= eta / (L + 1))).
{ clear Hall Hstep Hstart HLip. induction all as [|j l IH].
  - apply filter_forall. intros s j [].
  - assert (C := proj1 (filterlim_locally (y j) (y j t)) (Hy j t) (mkposreal _ Hd)).
    generalize (filter_and _ _ C IH). apply filter_imp. intros s [A B] m [<-|Hm]; auto. apply Rlt_le, A. }
revert Near. apply filter_imp. intros s Hs.
change (Rabs (h * f i (nearest (fun j => y j s)) - h * f i (nearest (fun j => y j t))) < eta).
eapply Rle_lt_trans. apply (HLip _ _ (eta / (L + 1))). intros j. apply Hs, Hall.
apply Rmult_lt_reg_r with (L + 1). lra.
replace (L * (eta / (L + 1)) * (L + 1)) with (L * eta) by (field; lra). assert (P := cond_pos eta). lra.
Qed.

Theorem step_solution : exists xi : I -> R -> R, (forall i, xi i 0 = start i) /\ solves f h xi 1 /\
  (forall t, 0 <= t <= 1 -> norm_at_most w (fun i => xi i t - x i t) r) /\
  forall T other, 0 <= T <= 1 -> (forall i, other i 0 = start i) -> solves f h other T ->
    forall i t, 0 <= t <= T -> other i t = xi i t.
Proof.
set (F := fun (i : I) (_ : R) v => h * f i (nearest v)).
assert (Lip : forall b, exists L, 0 <= L /\ forall s, Rabs (s - 0) <= b -> forall v v' c,
  (forall j, Rabs (v j - v' j) <= c) -> forall i, Rabs (F i s v - F i s v') <= L * c).
{ intros b. destruct nearest_lipschitz as (L & HL & H). exists L. exact (conj HL (fun s _ => H)). }
destruct (solution_exists I all Hall F nearest_continuous 0 Lip start) as (xi & H0 & D).
assert (N := narrow _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
assert (In_tube : forall t y, 0 <= t <= 1 -> norm_at_most w (fun i => y i t - x i t) r ->
  in_box low high (fun j => y j t)).
{ intros t y Ht B. apply (near_inside _ t Ht). intros j. apply Rle_trans with (1 := B j), Rmult_le_compat_r.
  apply Rlt_le, weight. lra. }
assert (B : forall t, 0 <= t <= 1 -> norm_at_most w (fun i => xi i t - x i t) r).
{ apply (tube_kept 1 xi (fun i t => F i t (fun j => xi j t))); auto. lra.
  intros i t Ht Hin. unfold F. rewrite (nearest_inside _ Hin). reflexivity. }
exists xi. refine (conj H0 (conj _ (conj B _))).
- intros i t Ht. eapply is_derive_val. apply D. unfold F. rewrite nearest_inside. reflexivity. apply In_tube; auto.
- intros T other HT O0 OD i t Ht.
  assert (BO := tube_kept T other (fun i t => h * f i (fun j => other j t)) HT O0 OD (fun _ _ _ _ => eq_refl)).
  apply (solution_unique I all Hall F 0 Lip).
  + intros j s Hs. unfold segment in Hs. rewrite Rmin_left, Rmax_right in Hs by lra.
    eapply is_derive_val. apply OD. lra. unfold F. rewrite nearest_inside. reflexivity. apply In_tube. lra. apply BO.
    lra.
  + intros j s _. apply D.
  + intros j. rewrite O0, H0. reflexivity.
Qed.

End Start.
End Step.

(** ** A whole set of starts

    The difference u of two solutions solves u' = h J(p) u, row by row with a point p of the tube. So u - Yh e, e the
    difference of the starts, solves a linear equation with a small rest, and [logarithmic_growth] bounds it at the end
    by w_i g sum_j |e_j| bound_j: enough for a matrix with entries within w_i g bound_j of Yh(1) that maps e to u(1). No
    derivative with respect to the start is used. *)

(** A number q that is at most G = sum_j E_j |e_j| in size is sum_j B_j e_j with |B_j| <= E_j: these B_j. *)
Definition share {I : Type} (all : list I) (E e : I -> R) (q : R) (j : I) : R :=
  let G := total all (fun j => E j * Rabs (e j)) in
  if Req_EM_T G 0 then 0 else q / G * (E j * if Rle_dec 0 (e j) then 1 else -1).

Lemma share_right {I : Type} (all : list I) (E e : I -> R) q : (forall j, 0 <= E j) ->
  Rabs q <= total all (fun j => E j * Rabs (e j)) ->
  (forall j, Rabs (share all E e q j) <= E j) /\ total all (fun j => share all E e q j * e j) = q.
Proof.
intros HE Hq. unfold share. set (G := total all (fun j => E j * Rabs (e j))) in *.
destruct (Req_EM_T G 0) as [Z|Z].
- split. { intros j. rewrite Rabs_R0. apply HE. }
  rewrite (total_ext all _ (fun _ => 0)) by (intros; ring). rewrite total_zero.
  symmetry. apply Rabs_eq_0, Rle_antisym; [lra|apply Rabs_pos].
- assert (P : 0 < G) by (generalize (Rabs_pos q); lra). split.
  + intros j. rewrite Rabs_mult, Rabs_mult, (Rabs_pos_eq (E j)) by apply HE.
    replace (Rabs (if Rle_dec 0 (e j) then 1 else -1)) with 1
      by (destruct Rle_dec; unfold Rabs; destruct Rcase_abs; lra).
    rewrite Rmult_1_r. rewrite <- (Rmult_1_l (E j)) at 2. apply Rmult_le_compat_r; [apply HE|].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ G)) by (apply Rlt_le, Rinv_0_lt_compat, P).
    apply Rmult_le_reg_r with G; auto. rewrite Rmult_assoc, Rinv_l by lra. lra.
  + rewrite (total_ext all _ (fun j => q / G * (E j * Rabs (e j)))).
    * rewrite total_scal. fold G. field. lra.
    * intros j. destruct Rle_dec; unfold Rabs; destruct Rcase_abs; try lra; ring.
Qed.

Section Set_of_starts.
Variables (I : Type) (all : list I) (f : I -> (I -> R) -> R) (J : I -> I -> (I -> R) -> R) (low high w : I -> R).
Variables (x x' : I -> R -> R) (h mu delta spread radius r : R) (Yh Yh' : I -> I -> R -> R) (c : I -> I -> R)
  (bound : I -> R).
Hypothesis Hall : forall i, In i all.
Hypothesis Hstep : step_checked all f J low high w x x' h mu delta spread radius r.
Hypothesis Hset : set_checked all J w x h r Yh Yh' c bound.

(** Column j of the equation of Yh with a row of J from anywhere in the tube. *)
Lemma column_defect t p i j : 0 <= t <= 1 -> norm_at_most w (fun l => p l - x l t) r ->
  Rabs (total all (fun k => h * J i k p * Yh k j t) - Yh' i j t) <= bound j * w i.
Proof.
intros Ht Hp. assert (Hh := length_pos _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
eapply Rle_trans; [|apply (matrix_defect _ _ _ _ _ _ _ _ _ _ Hset t Ht i j)].
set (Y := total all (fun k => h * J i k (fun l => x l t) * Yh k j t)).
replace (total all (fun k => h * J i k p * Yh k j t) - Yh' i j t)
  with (Y - Yh' i j t + (total all (fun k => h * J i k p * Yh k j t) - Y)) by ring.
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l. unfold Y. rewrite <- total_minus.
eapply Rle_trans; [apply total_abs|]. rewrite <- total_scal. apply total_le. intros k.
replace (h * J i k p * Yh k j t - h * J i k (fun l => x l t) * Yh k j t)
  with (h * ((J i k p - J i k (fun l => x l t)) * Yh k j t)) by ring.
rewrite !Rabs_mult, (Rabs_pos_eq h) by lra. apply Rmult_le_compat_l; [lra|].
apply Rmult_le_compat_r; [apply Rabs_pos|]. apply (jacobian_near _ _ _ _ _ _ _ _ _ _ Hset t Ht p Hp).
Qed.

(** Plan: both solutions stay in the tube (Bxi, Bzeta). q = xi - zeta - Yh e, e the difference of the starts, begins at
    0 and solves a linear equation with a matrix of the box, up to what [column_defect] bounds (Growth): so q(1) is
    small, and [share] distributes it over the columns of Yh(1). *)
Theorem set_of_solutions (xi zeta : I -> R -> R) : solves f h xi 1 -> solves f h zeta 1 ->
  norm_at_most w (fun i => xi i 0 - x i 0) spread -> (forall i, zeta i 0 = x i 0) ->
  exists A : I -> I -> R, (forall i j, Rabs (A i j - Yh i j 1) <= w i * exp (Rmax (h * mu) 0) * bound j) /\
    forall i, xi i 1 = zeta i 1 + total all (fun j => A i j * (xi j 0 - x j 0)).
Proof.
intros Dxi Dzeta Sxi Szeta. set (e := fun j => xi j 0 - x j 0). set (k := Rmax (h * mu) 0).
assert (Hh := length_pos _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
assert (Hw := weight _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep).
assert (Hk : 0 <= k) by apply Rmax_r.
assert (Tube : forall y, solves f h y 1 -> norm_at_most w (fun i => y i 0 - x i 0) spread ->
  forall t, 0 <= t <= 1 -> norm_at_most w (fun i => y i t - x i t) r).
{ intros y Dy Sy.
  apply (tube_kept I all f J low high w x x' h mu delta spread radius r Hall Hstep (fun i => y i 0) Sy 1 y
    (fun i t => h * f i (fun j => y j t))); auto. lra. }
assert (Bxi := Tube xi Dxi Sxi).
assert (Bzeta : forall t, 0 <= t <= 1 -> norm_at_most w (fun i => zeta i t - x i t) r).
{ apply Tube; auto. intros i. rewrite Szeta, Rminus_eq_0, Rabs_R0.
  apply Rle_trans with (2 := Sxi i). apply Rabs_pos. }
assert (Inside : forall y t, 0 <= t <= 1 -> norm_at_most w (fun i => y i t - x i t) r ->
  in_box low high (fun j => y j t)).
{ intros y t Ht B. apply (near_inside _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep _ t Ht). intros j.
  apply Rle_trans with (1 := B j), Rmult_le_compat_r. apply Rlt_le, Hw.
  apply Rlt_le, (narrow _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep). }
assert (Bound : forall j, 0 <= bound j).
{ intros j. apply Rmult_le_reg_r with (w j); auto. rewrite Rmult_0_l.
  apply Rle_trans with (2 := column_defect 0 (fun l => zeta l 0) j j ltac:(lra) (Bzeta 0 ltac:(lra))). apply Rabs_pos. }
set (size := total all (fun j => bound j * Rabs (e j))).
assert (Hsize : 0 <= size).
{ unfold size. rewrite <- (total_zero all). apply total_le. intros j.
  apply Rmult_le_pos; [apply Bound|apply Rabs_pos]. }
set (q := fun i t => xi i t - zeta i t - total all (fun j => Yh i j t * e j)).
set (q' := fun i t => h * f i (fun j => xi j t) - h * f i (fun j => zeta j t) - total all (fun j => Yh' i j t * e j)).
assert (Growth : norm_at_most w (fun i => q i 1) (exp (k * 1) * (0 + size * 1))).
{ apply (logarithmic_growth I all Hall w q q' k size 0 (exp (k * 1) * (0 + size * 1) + 1) 1 Hw Hk Hsize); try lra.
  - intros i t Ht. unfold q, q'. apply (is_derive_minus (fun t => xi i t - zeta i t)).
    + apply (is_derive_minus (xi i) (zeta i)); [apply Dxi|apply Dzeta]; exact Ht.
    + apply (total_derive all (fun j t => Yh i j t * e j) (fun j t => Yh' i j t * e j)). intros j.
      eapply is_derive_val.
      * apply (is_derive_mult_R (Yh i j) (fun _ => e j) t _ 0 (matrix_derivative _ _ _ _ _ _ _ _ _ _ Hset i j t Ht)).
        apply (is_derive_const (e j)).
      * ring.
  - intros t Ht _ i.
    destruct (field_difference I all f J low high w x x' h mu delta spread radius r Hstep (fun j => zeta j t) (fun j =>
      xi j t) i
      (Inside zeta t Ht (Bzeta t Ht)) (Inside xi t Ht (Bxi t Ht))) as (p & Hp & Ip & M).
    assert (Np : norm_at_most w (fun l => p l - x l t) r).
    { intros l. specialize (Hp l). assert (B1 := Bxi t Ht l). assert (B2 := Bzeta t Ht l). simpl in B1, B2.
      apply Rabs_le_between in B1. apply Rabs_le_between in B2. apply Rabs_le. revert Hp. unfold Rmin, Rmax.
      destruct Rle_dec; lra. }
    exists (fun l => h * J i l p),
      (total all (fun j => (total all (fun l => h * J i l p * Yh l j t) - Yh' i j t) * e j)). repeat split.
    + unfold q'. rewrite <- Rmult_minus_distr_l, M, <- total_scal.
      rewrite (total_ext all (fun j => (total all (fun l => h * J i l p * Yh l j t) - Yh' i j t) * e j)
        (fun j => e j * total all (fun l => h * J i l p * Yh l j t) - Yh' i j t * e j)) by (intros; ring).
      rewrite total_minus.
      rewrite (total_ext all (fun j => e j * total all (fun l => h * J i l p * Yh l j t))
        (fun j => total all (fun l => h * J i l p * (Yh l j t * e j)))).
      2: { intros j. rewrite <- total_scal. apply total_ext. intros; ring. }
      rewrite <- (total_swap all all (fun l j => h * J i l p * (Yh l j t * e j))).
      rewrite (total_ext all (fun l => total all (fun j => h * J i l p * (Yh l j t * e j)))
        (fun l => h * J i l p * total all (fun j => Yh l j t * e j))) by (intros; apply total_scal).
      unfold q.
      rewrite (total_ext all (fun l => h * J i l p * (xi l t - zeta l t - total all (fun j => Yh l j t * e j)))
        (fun l => h * (J i l p * (xi l t - zeta l t)) - h * J i l p * total all (fun j => Yh l j t * e j)))
        by (intros; ring).
      rewrite total_minus. ring.
    + rewrite (total_ext all _ (fun l => h * (Rabs (J i l p) * (w l / w i)))).
      2: { intros l. rewrite Rabs_mult, (Rabs_pos_eq h) by lra. ring. }
      rewrite Rabs_mult, (Rabs_pos_eq h), total_scal by lra. apply Rle_trans with (2 := Rmax_l (h * mu) 0).
      assert (Gr := growth _ _ _ _ _ _ _ _ _ _ _ _ _ _ Hstep p Ip i). simpl in Gr.
      apply (Rmult_le_compat_l h) in Gr; lra.
    + eapply Rle_trans; [apply total_abs|]. unfold size. rewrite (Rmult_comm _ (w i)), <- total_scal. apply total_le.
      intros j. rewrite Rabs_mult, <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rabs_pos|].
      rewrite (Rmult_comm (w i)). apply column_defect; auto.
  - intros i. unfold q. rewrite Szeta, (start_is_one _ _ _ _ _ _ _ _ _ _ Hset i e). unfold e.
    rewrite Rminus_eq_0, Rabs_R0. lra. }
set (E := fun i j => w i * exp k * bound j).
assert (Shares : forall i, (forall j, Rabs (share all (E i) e (q i 1) j) <= E i j) /\
  total all (fun j => share all (E i) e (q i 1) j * e j) = q i 1).
{ intros i. apply share_right.
  - intros j. apply Rmult_le_pos; [|apply Bound]. apply Rmult_le_pos; apply Rlt_le; [apply Hw|apply exp_pos].
  - rewrite (total_ext all (fun j => E i j * Rabs (e j)) (fun j => w i * exp k * (bound j * Rabs (e j))))
      by (intros; unfold E; ring).
    rewrite total_scal. fold size. assert (G := Growth i). simpl in G. rewrite Rmult_1_r in G. lra. }
exists (fun i j => Yh i j 1 + share all (E i) e (q i 1) j). split.
- intros i j. replace (Yh i j 1 + share all (E i) e (q i 1) j - Yh i j 1) with (share all (E i) e (q i 1) j) by ring.
  apply (Shares i).
- intros i. rewrite (total_ext all (fun j => (Yh i j 1 + share all (E i) e (q i 1) j) * (xi j 0 - x j 0))
    (fun j => Yh i j 1 * e j + share all (E i) e (q i 1) j * e j)) by (intros; unfold e; ring).
  rewrite total_plus, (proj2 (Shares i)). unfold q. ring.
Qed.

End Set_of_starts.

(** The hypotheses can be met: xi' = xi from 1, with the approximation 1 + t. *)
Example step_of_exponential : step_checked [tt] (fun _ v => v tt) (fun _ _ _ => 1) (fun _ => -3) (fun _ => 6) (fun _ =>
  1)
  (fun _ t => 1 + t) (fun _ _ => 1) 1 1 1 0 4 (exp 1).
Proof.
assert (E := exp_le_3). split; try (intros; lra).
- intros v _ i d. simpl. auto_derive; auto. ring.
- exists 1. intros. rewrite Rabs_R1. lra.
- intros v _ i. simpl. rewrite Rabs_R1. lra.
- intros i t _. auto_derive; auto.
- intros t Ht i. simpl. apply Rabs_le. lra.
- intros t Ht v Hv i. destruct i. specialize (Hv tt). simpl in Hv. apply Rabs_le_between in Hv. lra.
- rewrite Rmax_left by lra. rewrite Rmult_1_l. ring.
Qed.

Example set_of_exponential : set_checked [tt] (fun _ _ _ => 1) (fun _ => 1) (fun _ t => 1 + t) 1 (exp 1)
  (fun _ _ t => 1 + t) (fun _ _ _ => 1) (fun _ _ => 0) (fun _ => 1).
Proof.
split.
- intros [] e. simpl. ring.
- intros i j t _. auto_derive; auto.
- intros. rewrite Rminus_eq_0, Rabs_R0. lra.
- intros t Ht i j. simpl. rewrite Rabs_pos_eq; lra.
Qed.
