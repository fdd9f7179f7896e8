(** * One validated step: V1 of proofs/validated_step.md

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
