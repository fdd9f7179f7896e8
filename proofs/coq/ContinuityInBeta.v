(** * Continuity in b, and b -> n

    For b < 0 the integral is convex in the exponent, hence continuous; the recurrence carries this to every b that is not an
    integer >= 0, and gives Theta(t, b) -> P_n(t) as b -> n. At b = 0 it needs -t Theta(t, -1) + 2 Theta(t, -3) = 1. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral GammaFunction WellPosed ImproperIntegral Family
  SignsAtZero IntegerPolynomials.
Import ListNotations.
Open Scope R_scope.

Lemma Gamma_lim x : 0 < x -> is_lim Gamma x (Gamma x).
Proof.
intros Hx.
assert (H : is_lim (fun c => Gamma (c + 1)) (x - 1) (Gamma (x - 1 + 1))).
{ apply (convex_continuous (fun c => Gamma (c + 1)) (-1)); [|lra].
  apply (integral_convex (fun r => exp (- r)) (fun c => Gamma (c + 1))).
  - intros; apply Rlt_le, exp_pos.
  - intros c Hc. assert (H := Gamma_correct (c + 1) ltac:(lra)).
    replace (c + 1 - 1) with c in H by ring. exact H. }
apply is_lim_shift in H. replace (x - 1 + 1) with x in H by ring.
apply (is_lim_ext (fun y => Gamma (y - 1 + 1))); auto. intros y; f_equal; ring.
Qed.

(** continuity in b < 0 *)
Lemma Th_lim_neg b t : b < 0 -> is_lim (fun b => Th b t) b (Th b t).
Proof.
intros Hb.
set (G := fun c => Gamma (c + 1) * Th (- c - 1) t).
assert (HG : is_lim G (- b - 1) (G (- b - 1))).
{ apply (convex_continuous G (-1)); [|lra].
  apply (integral_convex (fun r => exp (r * t - r ^ 3 / 3)) G).
  - intros; apply Rlt_le, exp_pos.
  - intros c Hc.
    assert (Hn : not_nat (- c - 1)) by (apply not_nat_neg; lra).
    assert (H := Theta_representation (- c - 1) (Th (- c - 1)) 0 Hn ltac:(simpl; lra) (Th_correct _) t).
    simpl Derive_n in H. simpl INR in H.
    replace (0 - (- c - 1) - 1) with c in H by ring. unfold G.
    replace (c + 1) with (- (- c - 1)) by ring. exact H. }
assert (HG2 : is_lim (fun b => G (- b - 1)) b (G (- b - 1))).
{ apply (is_lim_reflect (fun c => G (c - 1))). apply is_lim_shift. exact HG. }
assert (HGam : is_lim (fun b => Gamma (- b)) b (Gamma (- b))).
{ apply (is_lim_reflect Gamma). apply Gamma_lim. lra. }
assert (Hg0 : Gamma (- b) <> 0) by (apply Rgt_not_eq, Gamma_pos; lra).
assert (HQ := is_lim_div (fun b => G (- b - 1)) (fun b => Gamma (- b)) b (G (- b - 1)) (Gamma (- b))
  HG2 HGam ltac:(intros H; apply Hg0; congruence) I).
apply (is_lim_ext_loc _ (fun b => Th b t)) in HQ.
- replace (Finite (Th b t)) with (Rbar_div (G (- b - 1)) (Gamma (- b))); auto.
  simpl. f_equal. unfold G. replace (- b - 1 + 1) with (- b) by ring. replace (- (- b - 1) - 1) with b by ring.
  field. exact Hg0.
- assert (Hb2 : 0 < - b) by lra.
  enough (HE : forall y : R, y < 0 -> G (- y - 1) / Gamma (- y) = Th y t).
  { exists (mkposreal _ Hb2). intros y Hy _. apply HE.
    unfold ball in Hy; simpl in Hy; unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    apply Rabs_def2 in Hy. simpl in *. lra. }
  intros y Hy. unfold G. replace (- y - 1 + 1) with (- y) by ring. replace (- (- y - 1) - 1) with y by ring.
  field. apply Rgt_not_eq, Gamma_pos. lra.
Qed.

(** ** The constant: -t Theta(t, -1) + 2 Theta(t, -3) = 1 *)
Lemma Th_constant t : - t * Th (-1) t + 2 * Th (-3) t = 1.
Proof.
set (f := fun t => - t * Th (-1) t + 2 * Th (-3) t).
assert (D : forall s, is_derive f s 0).
{ intros s. unfold f. evar_last.
  - apply (is_derive_plus (fun s => - s * Th (-1) s) (fun s => 2 * Th (-3) s)).
    + apply (is_derive_mult_R (fun s => - s) (Th (-1)) s (-1)).
      auto_derive; auto; ring. apply Th_derive, not_nat_neg; lra.
    + apply (is_derive_scal (Th (-3))). apply Th_derive, not_nat_neg; lra.
  - assert (H := Th_rec (-1) s (not_nat_neg (-1) ltac:(lra))).
    replace (-1 - 1) with (-2) in H |- * by ring. replace (-1 - 3) with (-4) in H by ring.
    replace (-3 - 1) with (-4) by ring. rewrite H. unfold plus; simpl. ring. }
assert (E0 : f 0 = 1).
{ unfold f. rewrite Ropp_0, Rmult_0_l, Rplus_0_l.
  destruct (Th_correct (-3)) as (_ & _ & I0 & _). rewrite I0.
  replace (- -3 / 3) with 1 by field. replace ((3 + -3) / 3) with 0 by field.
  rewrite Rpower_O by lra.
  replace (- -3) with (1 + 1 + 1) by ring. rewrite !Gamma_rec by lra. rewrite Gamma_1. field. }
change (f t = 1). rewrite <- E0.
destruct (Rtotal_order t 0) as [H|[->|H]]; auto.
- destruct (mvt_open f (fun _ => 0) t 0 H (fun s _ => D s)) as (d & _ & E). lra.
- destruct (mvt_open f (fun _ => 0) 0 t H (fun s _ => D s)) as (d & _ & E). lra.
Qed.

(** next to every real number, that number excepted, there are no natural numbers *)
Lemma near_not_nat (b : R) : Rbar_locally' b not_nat.
Proof.
assert (Hex : exists d, 0 < d /\ forall k : nat, INR k <> b -> d <= Rabs (INR k - b)).
{ destruct (Rlt_le_dec b 0) as [H|H].
  - exists (- b). split; [lra|]. intros k _. rewrite Rabs_pos_eq; generalize (pos_INR k); lra.
  - destruct (nfloor_ex b H) as [n [H1 H2]].
    destruct (Rle_lt_or_eq_dec _ _ H1) as [Hn|Hn].
    + exists (Rmin (b - INR n) (INR n + 1 - b)). split; [apply Rmin_pos; lra|]. intros k _.
      destruct (le_lt_dec k n) as [Hk|Hk].
      * apply le_INR in Hk. eapply Rle_trans; [apply Rmin_l|]. rewrite Rabs_left1; lra.
      * assert (Hk2 : INR (S n) <= INR k) by (apply le_INR; lia). rewrite S_INR in Hk2.
        eapply Rle_trans; [apply Rmin_r|]. rewrite Rabs_pos_eq; lra.
    + exists 1. split; [lra|]. intros k Hk. rewrite <- Hn in *.
      destruct (lt_eq_lt_dec k n) as [[Hkn|Hkn]|Hkn].
      * assert (Hk2 : INR (S k) <= INR n) by (apply le_INR; lia). rewrite S_INR in Hk2. rewrite Rabs_left1; lra.
      * subst k; congruence.
      * assert (Hk2 : INR (S n) <= INR k) by (apply le_INR; lia). rewrite S_INR in Hk2. rewrite Rabs_pos_eq; lra. }
destruct Hex as (d & Hd & Hk).
exists (mkposreal _ Hd). intros y Hy Hne k ->. specialize (Hk k Hne).
unfold ball in Hy; simpl in Hy; unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
unfold Rminus in Hk. lra.
Qed.

Lemma Th_lim_step (b t L1 L3 : R) :
  is_lim (fun b => Th b t) (b - 1) L1 -> is_lim (fun b => Th b t) (b - 3) L3 ->
  is_lim (fun b => Th b t) b (- t * L1 + (b - 1) * (b - 2) * L3).
Proof.
intros H1 H3.
apply is_lim_shift in H1. apply is_lim_shift in H3.
apply (is_lim_ext_loc (fun b => - t * Th (b - 1) t + (b - 1) * (b - 2) * Th (b - 3) t)).
{ eapply filter_imp; [|apply (near_not_nat b)]. intros y Hy. symmetry. apply Th_rec, Hy. }
apply is_lim_plus'.
- apply (is_lim_scal_l (fun b => Th (b - 1) t) (- t) b L1), H1.
- apply (is_lim_mult (fun b => (b - 1) * (b - 2)) (fun b => Th (b - 3) t) b
    ((b - 1) * (b - 2)) L3); [|exact H3|exact I].
  apply (is_lim_continuity (fun b => (b - 1) * (b - 2))).
  reg.
Qed.

(** Theta is continuous in b away from the integers 0, 1, 2, ... *)
Theorem Th_lim_cell (m : nat) : forall b t, cell m b -> is_lim (fun b => Th b t) b (Th b t).
Proof.
induction m as [m IH] using lt_wf_ind; intros b t Hb.
assert (Hn := cell_not_nat _ _ Hb).
destruct m as [|m].
- apply Th_lim_neg, cell_0, Hb.
- rewrite (Th_rec b t Hn). destruct (cell_S _ _ Hb) as [Hb1 _].
  apply Th_lim_step.
  + apply (IH m); auto.
  + destruct (Rlt_le_dec (b - 3) 0) as [H|H]; [apply Th_lim_neg, H|].
    destruct m as [|[|m]]; unfold cell in Hb; rewrite ?S_INR in Hb; simpl INR in Hb; try lra.
    apply (IH m); [lia|]. unfold cell. lra.
Qed.

Theorem Th_lim_not_nat (b t : R) : not_nat b -> is_lim (fun b => Th b t) b (Th b t).
Proof.
intros Hb. destruct (Rlt_le_dec b 0) as [H|H]. apply Th_lim_neg, H.
destruct (not_nat_cell b ltac:(lra) Hb) as [m Hm]. apply (Th_lim_cell m), Hm.
Qed.

(** Theta(t, b) -> P_n(t), b -> n. *)
Theorem Th_lim_integer (n : nat) : forall t, is_lim (fun b => Th b t) (INR n) (Pn n t).
Proof.
induction n as [n IH] using lt_wf_ind; intros t.
destruct n as [|[|[|n]]].
- change (Pn 0 t) with 1. rewrite <- (Th_constant t).
  replace (- t * Th (-1) t + 2 * Th (-3) t) with (- t * Th (-1) t + (INR 0 - 1) * (INR 0 - 2) * Th (-3) t)
    by (simpl; ring).
  apply Th_lim_step; simpl INR.
  + replace (0 - 1) with (-1) by ring. apply Th_lim_neg; lra.
  + replace (0 - 3) with (-3) by ring. apply Th_lim_neg; lra.
- replace (Pn 1 t) with (- t * Pn 0 t + (INR 1 - 1) * (INR 1 - 2) * Th (-2) t) by (simpl; ring).
  apply Th_lim_step.
  + replace (INR 1 - 1) with (INR 0) by (simpl; ring). apply IH; lia.
  + replace (INR 1 - 3) with (-2) by (simpl; ring). apply Th_lim_neg; lra.
- replace (Pn 2 t) with (- t * Pn 1 t + (INR 2 - 1) * (INR 2 - 2) * Th (-1) t) by (simpl; ring).
  apply Th_lim_step.
  + replace (INR 2 - 1) with (INR 1) by (simpl; ring). apply IH; lia.
  + replace (INR 2 - 3) with (-1) by (simpl; ring). apply Th_lim_neg; lra.
- replace (Pn (S (S (S n))) t) with (- t * Pn (S (S n)) t +
    (INR (S (S (S n))) - 1) * (INR (S (S (S n))) - 2) * Pn n t) by (rewrite Pn_rec, !S_INR; ring).
  apply Th_lim_step.
  + replace (INR (S (S (S n))) - 1) with (INR (S (S n))) by (rewrite !S_INR; ring). apply IH; lia.
  + replace (INR (S (S (S n))) - 3) with (INR n) by (rewrite !S_INR; ring). apply IH; lia.
Qed.
