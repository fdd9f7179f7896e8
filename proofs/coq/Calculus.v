(** * Elementary calculus

    The mean value theorem in the forms used here; a function with slope at least c > 0 is unbounded; a function that
    is its own first-order expansion up to h^2 is differentiable; a quantity E >= 0 with |E'| <= L E that vanishes once
    vanishes always; induction along the real line. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement.
Open Scope R_scope.

Lemma decr_of_derive (f df : R -> R) (a b : R) :
  a <= b ->
  (forall x, a <= x <= b -> is_derive f x (df x)) ->
  (forall x, a <= x <= b -> df x <= 0) -> f b <= f a.
Proof.
intros Hab Hd Hneg.
destruct (MVT_gen f a b df) as [c [Hc Heq]].
- intros x Hx; rewrite Rmin_left in Hx by lra; rewrite Rmax_right in Hx by lra.
  apply Hd; lra.
- intros x Hx; rewrite Rmin_left in Hx by lra; rewrite Rmax_right in Hx by lra.
  apply continuity_pt_filterlim, (ex_derive_continuous f x).
  exists (df x); apply Hd; lra.
- rewrite Rmin_left in Hc by lra; rewrite Rmax_right in Hc by lra.
  specialize (Hneg c Hc).
  assert (df c * (b - a) <= 0) by nra.
  lra.
Qed.

Lemma is_derive_mult_R (f g : R -> R) (x df dg : R) :
  is_derive f x df -> is_derive g x dg ->
  is_derive (fun t => f t * g t) x (df * g x + f x * dg).
Proof.
intros Hf Hg; apply (is_derive_mult f g x df dg Hf Hg).
intros n m; apply Rmult_comm.
Qed.

Lemma is_derive_val (f : R -> R) (x l l' : R) : is_derive f x l -> l = l' -> is_derive f x l'.
Proof. intros H <-; exact H. Qed.

Lemma ln_le_sub1 x : 0 < x -> ln x <= x - 1.
Proof.
intros Hx. generalize (exp_ineq1_le (ln x)). rewrite exp_ln by exact Hx. lra.
Qed.

Lemma exp_le (x y : R) : x <= y -> exp x <= exp y.
Proof.
intros H; destruct (Rle_lt_or_eq_dec _ _ H) as [H'|H'].
apply Rlt_le, exp_increasing, H'. rewrite H'; apply Rle_refl.
Qed.

(** ** Elementary calculus *)

Lemma mvt_open (f df : R -> R) (x y : R) : x < y ->
  (forall t, x <= t <= y -> is_derive f t (df t)) ->
  exists c, x < c < y /\ f y - f x = df c * (y - x).
Proof.
intros Hxy D.
destruct (MVT_cor2 f df x y Hxy) as [c [E Hc]].
- intros c Hc. apply is_derive_Reals, D, Hc.
- exists c; auto.
Qed.

Lemma derive_continuity (f df : R -> R) : (forall t, is_derive f t (df t)) -> continuity f.
Proof.
intros D s. apply continuity_pt_filterlim, (ex_derive_continuous f s). eexists; apply D.
Qed.

Lemma grow (h h' : R -> R) (c T0 : R) :
  (forall t, is_derive h t (h' t)) -> 0 < c -> (forall t, T0 <= t -> c <= h' t) ->
  forall M, exists T, T0 <= T /\ forall t, T <= t -> M <= h t.
Proof.
intros D Hc Hh M.
set (q := (Rabs M + Rabs (h T0)) / c).
assert (Hq : 0 <= q).
{ apply Rmult_le_pos. generalize (Rabs_pos M) (Rabs_pos (h T0)); lra.
  apply Rlt_le, Rinv_0_lt_compat, Hc. }
exists (T0 + q + 1). split. lra.
intros t Ht.
destruct (mvt_open h h' T0 t ltac:(lra) (fun t _ => D t)) as (d & Hd & E).
specialize (Hh d ltac:(lra)).
assert (H1 : c * q <= h' d * (t - T0)) by (apply Rmult_le_compat; lra).
replace (c * q) with (Rabs M + Rabs (h T0)) in H1 by (unfold q; field; lra).
generalize (Rle_abs M) (Rle_abs (- h T0)). rewrite Rabs_Ropp. lra.
Qed.

Lemma derive_of_quadratic (f : R -> R) (t l C : R) :
  (forall h, Rabs h <= 1 -> Rabs (f (t + h) - f t - h * l) <= h ^ 2 * C) ->
  is_derive f t l.
Proof.
intros H. apply is_derive_Reals. intros eps Heps.
assert (HC : 0 <= C).
{ specialize (H 1). rewrite Rabs_R1 in H. specialize (H (Rle_refl 1)).
  generalize (Rabs_pos (f (t + 1) - f t - 1 * l)). lra. }
assert (Hd : 0 < Rmin 1 (eps / (C + 1))).
{ apply Rmin_pos. lra. apply Rdiv_lt_0_compat; lra. }
exists (mkposreal _ Hd). intros h Hh Hhd. simpl in Hhd.
assert (H1 : Rabs h < 1) by (eapply Rlt_le_trans; [exact Hhd|apply Rmin_l]).
assert (H2 : Rabs h < eps / (C + 1)) by (eapply Rlt_le_trans; [exact Hhd|apply Rmin_r]).
specialize (H h ltac:(lra)).
replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - h * l) * / h) by (field; auto).
rewrite Rabs_mult, Rabs_inv.
assert (Hp : 0 < Rabs h) by (apply Rabs_pos_lt; auto).
apply Rmult_lt_reg_r with (Rabs h); auto.
rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
replace (h ^ 2) with (Rabs h * Rabs h) in H by (rewrite <- Rabs_mult, Rabs_pos_eq; simpl; nra).
eapply Rle_lt_trans; [exact H|].
assert (Rabs h * (C + 1) < eps).
{ replace eps with (eps / (C + 1) * (C + 1)) by (field; lra). apply Rmult_lt_compat_r; lra. }
assert (Rabs h * (Rabs h * (C + 1)) < Rabs h * eps) by (apply Rmult_lt_compat_l; lra).
nra.
Qed.

Lemma one_step_zero (E E' : R -> R) (t0 t L : R) :
  (forall s, Rmin t0 t <= s <= Rmax t0 t -> is_derive E s (E' s)) -> (forall s, 0 <= E s) -> E t0 = 0 ->
  (forall s, Rmin t0 t <= s <= Rmax t0 t -> Rabs (E' s) <= L * E s) -> E t = 0.
Proof.
intros D Hp H0 HL.
apply Rle_antisym; auto.
destruct (Rle_lt_dec t0 t) as [H|H].
- rewrite Rmin_left, Rmax_right in D, HL by lra.
  assert (G : E t * exp (- L * (t - t0)) <= E t0 * exp (- L * (t0 - t0))).
  { apply (decr_of_derive (fun s => E s * exp (- L * (s - t0)))
       (fun s => (E' s - L * E s) * exp (- L * (s - t0))) t0 t H).
    - intros s Hs. evar_last.
      apply (is_derive_mult_R E (fun s => exp (- L * (s - t0))) s (E' s) (- L * exp (- L * (s - t0)))).
      apply D; lra. auto_derive; auto; unfold Rminus; ring. ring.
    - intros s Hs.
      generalize (HL s Hs) (Rle_abs (E' s)) (exp_pos (- L * (s - t0))). intros. nra. }
  rewrite H0, Rmult_0_l in G.
  generalize (exp_pos (- L * (t - t0))). intros.
  apply Rmult_le_reg_r with (exp (- L * (t - t0))); auto. lra.
- rewrite Rmin_right, Rmax_left in D, HL by lra.
  assert (G : - (E t0 * exp (L * (t0 - t0))) <= - (E t * exp (L * (t - t0)))).
  { apply (decr_of_derive (fun s => - (E s * exp (L * (s - t0))))
       (fun s => - ((E' s + L * E s) * exp (L * (s - t0)))) t t0 (Rlt_le _ _ H)).
    - intros s Hs. apply (is_derive_opp (fun s => E s * exp (L * (s - t0)))). evar_last.
      apply (is_derive_mult_R E (fun s => exp (L * (s - t0))) s (E' s) (L * exp (L * (s - t0)))).
      apply D; lra. auto_derive; auto; unfold Rminus; ring. ring.
    - intros s Hs.
      generalize (HL s Hs) (Rle_abs (- E' s)) (exp_pos (L * (s - t0))). rewrite Rabs_Ropp. intros. nra. }
  rewrite H0, Rmult_0_l in G.
  generalize (exp_pos (L * (t - t0))). intros.
  apply Rmult_le_reg_r with (exp (L * (t - t0))); auto. lra.
Qed.

Lemma real_induction (P : R -> Prop) (t0 : R) : P t0 ->
  (forall t, t0 <= t -> (forall s, t0 <= s <= t -> P s) -> exists d, 0 < d /\ forall s, t <= s < t + d -> P s) ->
  (forall t, t0 < t -> (forall s, t0 <= s < t -> P s) -> P t) ->
  forall t, t0 <= t -> P t.
Proof.
intros H0 Ho Hc t Ht.
destruct (Classical_Prop.classic (P t)) as [H|H]; auto. exfalso.
set (E := fun x => t0 <= x /\ forall s, t0 <= s <= x -> P s).
assert (HE0 : E t0).
{ split. lra. intros s Hs. replace s with t0 by lra. exact H0. }
destruct (completeness E) as [m [Hub Hlub]].
- exists t. intros x [Hx1 Hx2]. apply Rnot_lt_le. intros Hlt. apply H, Hx2. lra.
- exists t0; auto.
- assert (Hm : t0 <= m) by (apply Hub, HE0).
  assert (Hb : forall s, t0 <= s < m -> P s).
  { intros s Hs. destruct (Classical_Prop.classic (P s)) as [Hp|Hp]; auto. exfalso.
    assert (m <= s).
    { apply Hlub. intros x [Hx1 Hx2]. apply Rnot_lt_le. intros Hlt. apply Hp, Hx2. lra. }
    lra. }
  assert (Pm : P m).
  { destruct (Rle_lt_or_eq_dec _ _ Hm) as [Hl|Hl]. apply Hc; auto. rewrite <- Hl; auto. }
  assert (Hb' : forall s, t0 <= s <= m -> P s).
  { intros s Hs. destruct (Rle_lt_or_eq_dec _ _ (proj2 Hs)) as [Hl|Hl]. apply Hb; lra. rewrite Hl; auto. }
  destruct (Ho m Hm Hb') as (d & Hd & Hd').
  assert (E (m + d / 2)).
  { split. lra. intros s Hs. destruct (Rle_lt_dec s m). apply Hb'; lra. apply Hd'. lra. }
  assert (m + d / 2 <= m) by (apply Hub; auto). lra.
Qed.

Lemma continuous_pos (f : R -> R) (t : R) : ex_derive f t -> 0 < f t -> locally t (fun s => 0 < f s).
Proof.
intros Hf Hp. apply (ex_derive_continuous f t) in Hf.
exact (Hf (fun u => 0 < u) (open_gt 0 (f t) Hp)).
Qed.

Lemma closed_ge (f : R -> R) (t0 t m : R) : t0 < t -> ex_derive f t -> (forall s, t0 <= s < t -> m <= f s) -> m <= f t.
Proof.
intros Ht Hf H. apply Rnot_lt_le. intros Hlt.
assert (L : locally t (fun s => 0 < m - f s)).
{ apply (continuous_pos (fun s => m - f s)); [|lra]. auto_derive; auto. }
destruct L as [d Hd].
set (s := Rmax t0 (t - d / 2)).
assert (Hdp := cond_pos d).
assert (S1 : t0 <= s) by apply Rmax_l. assert (S2 : t - d / 2 <= s) by apply Rmax_r.
assert (S3 : s < t) by (unfold s, Rmax; destruct Rle_dec; lra).
specialize (H s ltac:(lra)).
assert (0 < m - f s).
{ apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_left1; lra. }
lra.
Qed.

Lemma derive_zero_of_const (f df : R -> R) (x y k p : R) :
  (forall t, is_derive f t (df t)) -> x < p < y -> (forall t, x < t < y -> f t = k) -> df p = 0.
Proof.
intros D Hp E.
assert (H : is_derive f p 0).
{ apply (is_derive_ext_loc (fun _ => k)).
  - assert (Hd : 0 < Rmin (p - x) (y - p)) by (apply Rmin_pos; lra).
    exists (mkposreal _ Hd). intros t Ht. symmetry. apply E.
    apply Rabs_def2 in Ht. unfold minus, plus, opp in Ht; simpl in Ht.
    generalize (Rmin_l (p - x) (y - p)) (Rmin_r (p - x) (y - p)). lra.
  - apply (is_derive_const k). }
rewrite <- (is_derive_unique f p _ (D p)). apply is_derive_unique, H.
Qed.

Lemma neg_of_prod_pos x y : x < 0 -> 0 < x * y -> y < 0.
Proof.
intros Hx Hxy. apply Rnot_le_lt; intros H0.
assert (0 <= (- x) * y) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma pos_of_prod_pos x y : 0 < x -> 0 < x * y -> 0 < y.
Proof.
intros Hx Hxy. apply Rnot_le_lt; intros H0.
assert (0 <= x * (- y)) by (apply Rmult_le_pos; lra). lra.
Qed.
