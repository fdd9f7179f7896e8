(** * Theta(., b) on closed cells of b, the integers included

    What the pieces of a certificate rest on: F b = Theta(., b) for every real b, that is P_n at b = n. Its slope, its
    sign for b <= 0 and at t = 0, its highest derivative; F is continuous in b. A function of b that increases with a
    piecewise constant weight e^(wb) on finitely many intervals stays positive from a value >= 0 on (proofs/check.md,
    section 4). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Classical.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCertificate Calculus LaplaceIntegral WellPosed Family SignsAtZero
  IntegerPolynomials PolynomialSum Ends
  ContinuityInBeta EntireForm DifferentiableInBeta.
From GSpot Require Import CertificateWalk.
Import ListNotations.
Open Scope R_scope.

Lemma nat_or_not (b : R) : (exists n : nat, b = INR n) \/ not_nat b.
Proof.
destruct (classic (exists n : nat, b = INR n)) as [H|H]; auto. right. intros n E. apply H. exists n. exact E.
Qed.

(** ** The polynomials: all derivatives *)
Lemma Pn_Derive_n m : forall k t, (k <= m)%nat ->
  Derive_n (Pn m) k t = (-1) ^ k * (INR (fact m) / INR (fact (m - k))) * Pn (m - k) t.
Proof.
induction k as [|k IH]; intros t Hk.
- simpl. rewrite Nat.sub_0_r. field. apply INR_fact_neq_0.
- change (Derive_n (Pn m) (S k) t) with (Derive (Derive_n (Pn m) k) t).
  rewrite (Derive_ext _ (fun t => (-1) ^ k * (INR (fact m) / INR (fact (m - k))) * Pn (m - k) t))
    by (intros; apply IH; lia).
  rewrite Derive_scal, Pn_Derive. unfold Pn1.
  replace (m - S k)%nat with (m - k - 1)%nat by lia. replace (m - k)%nat with (S (m - k - 1)) by lia.
  replace (S (m - k - 1) - 1)%nat with (m - k - 1)%nat by lia.
  rewrite fact_simpl, mult_INR. simpl pow. field. split; [apply INR_fact_neq_0|apply not_0_INR; lia].
Qed.

Lemma Pn_Derive_n_derive m k t : (k <= m)%nat -> is_derive (Derive_n (Pn m) k) t (Derive_n (Pn m) (S k) t).
Proof.
intros Hk. apply Derive_correct.
apply (ex_derive_ext (fun t => (-1) ^ k * (INR (fact m) / INR (fact (m - k))) * Pn (m - k) t)).
- intros s. symmetry. apply Pn_Derive_n, Hk.
- apply ex_derive_scal. eexists. apply Pn_derive'.
Qed.

Lemma Pn_top m t : Derive_n (Pn m) m t = (-1) ^ m * INR (fact m).
Proof. rewrite Pn_Derive_n by lia. rewrite Nat.sub_diag. simpl. field. Qed.

(** ** The family *)
Section Family.
Variable F : R -> R -> R.
Hypothesis HF : theta_family F.

Lemma family_theta b : not_nat b -> is_Theta b (F b).
Proof. intros Hb. apply (proj1 (EntireForm.entire_initial_values b (F b)) Hb), HF. Qed.

Lemma family_Th b t : not_nat b -> F b t = Th b t.
Proof. intros Hb. apply Th_is, family_theta, Hb. Qed.

Lemma family_Pn n t : F (INR n) t = Pn n t.
Proof.
rewrite <- Poly_Pn. apply (proj2 (proj2 (EntireForm.entire_initial_values (INR n) (F (INR n))) n eq_refl)), HF.
Qed.

Lemma family_Derive_n_Pn n k t : Derive_n (F (INR n)) k t = Derive_n (Pn n) k t.
Proof. apply Derive_n_ext, family_Pn. Qed.

Lemma family_derive b t : is_derive (F b) t (Derive (F b) t).
Proof. apply (entire_chain b (F b) (HF b)). Qed.

Lemma family_derive2 b t : is_derive (Derive (F b)) t (Derive_n (F b) 2 t).
Proof. apply (entire_chain b (F b) (HF b)). Qed.

(** Theta' = - b Theta(., b - 1), at integers too. *)
Lemma family_slope b t : Derive (F b) t = - b * F (b - 1) t.
Proof.
destruct (nat_or_not b) as [[n ->]|Hb].
- rewrite (Derive_ext _ (Pn n)) by apply family_Pn. rewrite Pn_Derive. unfold Pn1. destruct n as [|n].
  + simpl. ring.
  + replace (INR (S n) - 1) with (INR n) by (rewrite S_INR; ring). rewrite family_Pn. simpl Nat.sub.
    rewrite Nat.sub_0_r. reflexivity.
- apply (Theta_derive b); auto using family_theta. apply family_theta, not_nat_pred, Hb.
Qed.

Lemma family_second b t : Derive_n (F b) 2 t = - b * Derive (F (b - 1)) t.
Proof.
change (Derive (Derive (F b)) t = - b * Derive (F (b - 1)) t).
rewrite (Derive_ext _ (fun t => - b * F (b - 1) t)) by apply family_slope. apply Derive_scal.
Qed.

Lemma family_positive b t : b <= 0 -> 0 < F b t.
Proof.
intros Hb. destruct (Rle_lt_or_eq_dec _ _ Hb) as [H| ->].
- rewrite family_Th by (apply not_nat_neg, H). apply Th_pos, H.
- change 0 with (INR 0) at 2. rewrite family_Pn. simpl. lra.
Qed.

(** The sign at t = 0 on a closed cell, m >= 1: - only if m = 2 mod 3; it is 0 at an integer b = 1 or 2 mod 3 alone. *)
Lemma family_sign_0 (m : nat) b : (1 <= m)%nat -> INR m - 1 <= b <= INR m ->
  let s := negb (Nat.eqb (m mod 3) 2) in
  0 <= signed s (F b 0) /\ ((forall n : nat, b = INR n -> (n mod 3 = 0)%nat) -> 0 < signed s (F b 0)).
Proof.
intros Hm Hb s.
assert (E3 : (m mod 3 = ((m - 1) mod 3 + 1) mod 3)%nat).
{ rewrite Nat.add_mod_idemp_l by lia. f_equal. lia. }
assert (L := Nat.mod_upper_bound (m - 1) 3 ltac:(lia)).
assert (At : forall n, (n = m \/ n = m - 1)%nat -> 0 <= signed s (F (INR n) 0) /\
  ((n mod 3 = 0)%nat -> 0 < signed s (F (INR n) 0))).
{ intros n Hn. rewrite family_Pn. assert (P := Pn_0 n). assert (L' := Nat.mod_upper_bound n 3 ltac:(lia)).
  unfold s. destruct Hn as [->| ->].
  - destruct (m mod 3)%nat as [|[|[|k]]] eqn:E; try lia; simpl; split; try intros; try lra; try discriminate.
  - rewrite E3. destruct ((m - 1) mod 3)%nat as [|[|[|k]]] eqn:E; try lia; simpl; split; try intros; try lra;
      try discriminate. }
destruct (Rle_lt_or_eq_dec _ _ (proj1 Hb)) as [Hlo|Hlo].
- destruct (Rle_lt_or_eq_dec _ _ (proj2 Hb)) as [Hhi| ->].
  + assert (C : cell m b) by (split; lra).
    assert (P := sign_0 m b C). rewrite sg_mod in P. rewrite <- family_Th in P by (apply (cell_not_nat m), C).
    assert (Q : 0 < signed s (F b 0)).
    { unfold s. destruct (Nat.eqb (m mod 3) 2); simpl; lra. }
    split; [lra|auto].
  + destruct (At m ltac:(auto)) as [A B]. split; auto.
- assert (E : b = INR (m - 1)) by (rewrite minus_INR by lia; simpl; lra). rewrite E.
  destruct (At (m - 1)%nat ltac:(auto)) as [A B]. split; auto.
Qed.

(** F is continuous in b at every b, and differentiable off the integers. *)
Lemma family_continuous b t : continuity_pt (fun b => F b t) b.
Proof.
apply continuity_pt_filterlim'.
assert (H : is_lim (fun b => F b t) b (F b t)); [|exact H].
apply (is_lim_ext_loc (fun b => Th b t)).
- eapply filter_imp; [|apply (near_not_nat b)]. intros y Hy. symmetry. apply family_Th, Hy.
- destruct (nat_or_not b) as [[n ->]|Hb].
  + rewrite family_Pn. apply Th_lim_integer.
  + rewrite family_Th by auto. apply Th_lim_not_nat, Hb.
Qed.

Lemma family_derive_in_b b t : not_nat b -> is_derive (fun b => F b t) b (Derive (fun b => F b t) b).
Proof.
intros Hb. apply Derive_correct. apply (ex_derive_ext_loc (fun b => Th b t)); [|apply Th_ex_derive, Hb].
eapply filter_imp; [|apply (not_nat_open b Hb)]. intros x Hx. symmetry. apply family_Th, Hx.
Qed.

End Family.

(** ** Increase with a weight *)
Lemma mvt_inside (f df : R -> R) x y : x < y -> (forall t, x < t < y -> is_derive f t (df t)) ->
  (forall t, x <= t <= y -> continuity_pt f t) -> exists c, x < c < y /\ f y - f x = df c * (y - x).
Proof.
intros Hxy D C.
assert (pr : forall c, x < c < y -> derivable_pt f c).
{ intros c Hc. exists (df c). apply is_derive_Reals, D, Hc. }
destruct (MVT f id x y pr (fun c _ => derivable_pt_id c) Hxy C (fun c _ =>
  derivable_continuous_pt _ _ (derivable_pt_id c)))
  as (c & P & E).
exists c. split; [exact P|].
rewrite derive_pt_id in E. unfold id in E.
assert (Ed : derive_pt f c (pr c P) = df c).
{ apply derive_pt_eq_0, is_derive_Reals, D, P. }
rewrite Ed in E. lra.
Qed.

Lemma weighted_step (g g' : R -> R) w x y : x < y -> (forall t, x < t < y -> is_derive g t (g' t)) ->
  (forall t, x <= t <= y -> continuity_pt g t) -> (forall t, x < t < y -> 0 < g' t + w * g t) -> 0 <= g x -> 0 < g y.
Proof.
intros Hxy D C P H0.
destruct (mvt_inside (fun t => exp (w * t) * g t) (fun t => exp (w * t) * (g' t + w * g t)) x y Hxy) as (c & Hc & E).
- intros t Ht. assert (A := D t Ht).
  eapply is_derive_val. apply (is_derive_mult_R (fun t => exp (w * t)) g).
  + instantiate (1 := w * exp (w * t)). auto_derive; auto. ring.
  + exact A.
  + ring.
- intros t Ht. apply continuity_pt_mult; [|apply C, Ht].
  apply derivable_continuous_pt. apply ex_derive_Reals_0. auto_derive; auto.
- assert (A : 0 < exp (w * c) * (g' c + w * g c) * (y - x)).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; [apply exp_pos|apply P, Hc|lra]. }
  assert (B : 0 <= exp (w * x) * g x) by (apply Rmult_le_pos; [apply Rlt_le, exp_pos|exact H0]).
  apply Rmult_lt_reg_l with (exp (w * y)); [apply exp_pos|]. lra.
Qed.

(** Of finitely many convex sets of which one meets every (0, d), one holds some (0, d). *)
Lemma one_near_0 (A : Type) (Q : A -> R -> Prop) (l : list A) :
  (forall a x y z, Q a x -> Q a z -> x <= y <= z -> Q a y) ->
  (forall d, 0 < d -> exists u a, 0 < u < d /\ In a l /\ Q a u) ->
  exists a d, In a l /\ 0 < d /\ forall u, 0 < u < d -> Q a u.
Proof.
intros HQ. induction l as [|a l IH]; intros H.
- destruct (H 1 Rlt_0_1) as (u & a & _ & [] & _).
- destruct (classic (exists d, 0 < d /\ forall u, 0 < u < d -> ~ Q a u)) as [(d & Hd & Hn)|Hn].
  + destruct IH as (a' & d' & I & Hd' & Q').
    * intros e He. assert (M := Rmin_l e d). assert (M' := Rmin_r e d).
      destruct (H (Rmin e d) ltac:(apply Rmin_glb_lt; auto)) as (u & a' & Hu & [<-|I] & Q').
      -- exfalso. apply (Hn u); auto. lra.
      -- exists u, a'. repeat split; auto; lra.
    * exists a', d'. split; [right; exact I|]. auto.
  + assert (N : forall d, 0 < d -> exists u, 0 < u < d /\ Q a u).
    { intros d Hd. apply NNPP. intros C. apply Hn. exists d. split; auto. intros u Hu Qu. apply C. exists u. auto. }
    destruct (N 1 Rlt_0_1) as (u0 & H0 & Q0). exists a, u0. split; [left; reflexivity|]. split; [lra|].
    intros u Hu. destruct (N u ltac:(lra)) as (u1 & H1 & Q1). apply (HQ a u1 u u0); auto. lra.
Qed.

Lemma weighted_increase (A : Type) (Q : A -> R -> Prop) (w : A -> R) (l : list A) (g g' : R -> R) lo hi :
  (forall a x y z, Q a x -> Q a z -> x <= y <= z -> Q a y) ->
  (forall b, lo <= b <= hi -> exists a, In a l /\ Q a b) ->
  (forall b, continuity_pt g b) -> (forall b, lo < b < hi -> is_derive g b (g' b)) ->
  (forall b a, In a l -> Q a b -> lo < b < hi -> 0 < g' b + w a * g b) ->
  0 <= g lo -> forall b, lo < b <= hi -> 0 < g b.
Proof.
intros HQ Hcover C D P H0 b Hb.
assert (Near : forall x e, (e = 1 /\ lo <= x < hi) \/ (e = -1 /\ lo < x <= hi) ->
  exists a d, In a l /\ 0 < d /\ forall u, 0 < u < d -> Q a (x + e * u)).
{ intros x e He. apply (one_near_0 A (fun a u => Q a (x + e * u))).
  - intros a u v z Qu Qz Hv. destruct He as [[-> _]|[-> _]].
    + apply (HQ a (x + 1 * u) _ (x + 1 * z)); auto. lra.
    + apply (HQ a (x + -1 * z) _ (x + -1 * u)); auto. lra.
  - intros d Hd. destruct He as [[-> Hx]|[-> Hx]].
    + set (u := Rmin (d / 2) (hi - x)). assert (U1 := Rmin_l (d / 2) (hi - x)). assert (U2 := Rmin_r (d / 2) (hi - x)).
      fold u in U1, U2.
      assert (U0 : 0 < u) by (apply Rmin_glb_lt; lra).
      destruct (Hcover (x + 1 * u) ltac:(lra)) as (a & I & Qa). exists u, a. repeat split; auto; lra.
    + set (u := Rmin (d / 2) (x - lo)). assert (U1 := Rmin_l (d / 2) (x - lo)). assert (U2 := Rmin_r (d / 2) (x - lo)).
      fold u in U1, U2.
      assert (U0 : 0 < u) by (apply Rmin_glb_lt; lra).
      destruct (Hcover (x + -1 * u) ltac:(lra)) as (a & I & Qa). exists u, a. repeat split; auto; lra. }
enough (H : b <= hi -> lo < b -> 0 < g b) by (apply H; lra).
apply (real_induction (fun b => b <= hi -> lo < b -> 0 < g b) lo); [lra| | |lra].
- intros t Ht IH. destruct (Rlt_le_dec t hi) as [Hlt|Hge].
  + destruct (Near t 1 ltac:(left; lra)) as (a & d & I & Hd & Qa).
    exists (Rmin d (hi - t)). split; [apply Rmin_glb_lt; lra|].
    assert (M1 := Rmin_l d (hi - t)). assert (M2 := Rmin_r d (hi - t)).
    assert (G : 0 <= g t).
    { destruct (Rle_lt_or_eq_dec _ _ Ht) as [L|<-]; [apply Rlt_le, (IH t); lra|exact H0]. }
    intros s Hs Hsh Hls. destruct (Rle_lt_or_eq_dec _ _ (proj1 Hs)) as [L|<-]; [|apply (IH t); lra].
    apply (weighted_step g g' (w a) t s L); auto.
    * intros u Hu. apply D. lra.
    * intros u Hu. apply P; auto; [|lra]. replace u with (t + 1 * (u - t)) by ring. apply Qa. lra.
  + exists 1. split; [lra|]. intros s Hs Hsh Hls. apply (IH s); lra.
- intros t Ht IH Hth _.
  destruct (Near t (-1) ltac:(right; lra)) as (a & d & I & Hd & Qa).
  set (s := Rmax (t - d / 2) ((lo + t) / 2)).
  assert (S1 := Rmax_l (t - d / 2) ((lo + t) / 2)). assert (S2 := Rmax_r (t - d / 2) ((lo + t) / 2)). fold s in S1, S2.
  assert (S3 : s < t) by (apply Rmax_lub_lt; lra).
  apply (weighted_step g g' (w a) s t S3); auto.
  + intros u Hu. apply D. lra.
  + intros u Hu. apply P; auto; [|lra]. replace u with (t + -1 * (t - u)) by ring. apply Qa. lra.
  + apply Rlt_le, (IH s); lra.
Qed.
