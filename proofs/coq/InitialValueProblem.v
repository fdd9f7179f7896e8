(** * Initial value problems on the whole line

    x' = f(t, x) for finitely many components, f continuous along continuous functions and Lipschitz in x, on each
    compact interval with one constant: from every state there is a solution on R ([solution_exists], by Picard's
    iteration; consecutive iterates differ by at most M L^n |t - t0|^(n+1)/(n+1)!), and two solutions on an interval
    that agree at one time agree on it ([solution_unique], by the same bound). *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus.
Open Scope R_scope.

(** f(t0) = 0 and |f'| <= c |s - t0|^n/n! give |f| <= c |t - t0|^(n+1)/(n+1)!. *)
Lemma power_bound_right (f f' : R -> R) (t0 t c : R) (n : nat) : t0 <= t ->
  (forall s, t0 <= s <= t -> is_derive f s (f' s)) ->
  (forall s, t0 <= s <= t -> Rabs (f' s) <= c * (s - t0) ^ n / INR (fact n)) ->
  Rabs (f t - f t0) <= c * (t - t0) ^ S n / INR (fact (S n)).
Proof.
intros Ht D H.
assert (Hf := INR_fact_lt_0 n). assert (Hn := lt_0_INR (S n) (Nat.lt_0_succ n)).
assert (DP : forall s, is_derive (fun s => c * (s - t0) ^ S n / INR (fact (S n))) s (c * (s - t0) ^ n / INR (fact n))).
{ intros s. apply (is_derive_ext (fun s => c / INR (fact (S n)) * (s - t0) ^ S n)).
  { intros u. unfold Rdiv.
    change (@eq R (c * / INR (fact (S n)) * (u - t0) ^ S n) (c * (u - t0) ^ S n * / INR (fact (S n)))). ring. }
  eapply is_derive_val.
  - apply (is_derive_scal (fun s => (s - t0) ^ S n)). apply is_derive_pow.
    apply (is_derive_minus (fun s => s) (fun _ => t0)). apply (is_derive_id s). apply (is_derive_const t0).
  - unfold minus, plus, opp, one, zero; cbn -[INR fact pow].
    rewrite fact_simpl, mult_INR. change (Init.Nat.pred (S n)) with n. field. lra. }
assert (P0 : c * (t0 - t0) ^ S n / INR (fact (S n)) = 0) by (simpl; unfold Rdiv; ring).
assert (U : f t - c * (t - t0) ^ S n / INR (fact (S n)) <= f t0 - c * (t0 - t0) ^ S n / INR (fact (S n))).
{ apply (decr_of_derive (fun s => f s - c * (s - t0) ^ S n / INR (fact (S n))) (fun s =>
    f' s - c * (s - t0) ^ n / INR (fact n))); auto.
  - intros s Hs. apply (is_derive_minus f); auto.
  - intros s Hs. specialize (H s Hs). generalize (Rle_abs (f' s)). lra. }
assert (L : - f t - c * (t - t0) ^ S n / INR (fact (S n)) <= - f t0 - c * (t0 - t0) ^ S n / INR (fact (S n))).
{ apply (decr_of_derive (fun s => - f s - c * (s - t0) ^ S n / INR (fact (S n))) (fun s =>
    - f' s - c * (s - t0) ^ n / INR (fact n))); auto.
  - intros s Hs. apply (is_derive_minus (fun s => - f s)); auto. apply (is_derive_opp f); auto.
  - intros s Hs. specialize (H s Hs). generalize (Rle_abs (- f' s)). rewrite Rabs_Ropp. lra. }
rewrite P0 in U, L. apply Rabs_le. lra.
Qed.

Definition segment (t0 t s : R) : Prop := Rmin t0 t <= s <= Rmax t0 t.

Lemma power_bound (f f' : R -> R) (t0 t c : R) (n : nat) :
  (forall s, segment t0 t s -> is_derive f s (f' s)) ->
  (forall s, segment t0 t s -> Rabs (f' s) <= c * Rabs (s - t0) ^ n / INR (fact n)) ->
  Rabs (f t - f t0) <= c * Rabs (t - t0) ^ S n / INR (fact (S n)).
Proof.
unfold segment. intros D H. destruct (Rle_dec t0 t) as [Ht|Ht].
- rewrite Rmin_left, Rmax_right in D, H by lra. rewrite (Rabs_pos_eq (t - t0)) by lra.
  apply power_bound_right with f'; auto. intros s Hs. rewrite <- (Rabs_pos_eq (s - t0)) by lra. auto.
- rewrite Rmin_right, Rmax_left in D, H by lra. rewrite (Rabs_left1 (t - t0)) by lra.
  assert (G := power_bound_right (fun s => f (2 * t0 - s)) (fun s => - f' (2 * t0 - s)) t0 (2 * t0 - t) c n ltac:(lra)).
  cbv beta in G. replace (2 * t0 - (2 * t0 - t)) with t in G by ring. replace (2 * t0 - t0) with t0 in G by ring.
  replace (2 * t0 - t - t0) with (- (t - t0)) in G by ring. apply G.
  + intros s Hs. eapply is_derive_val.
    * apply (is_derive_comp f (fun s => 2 * t0 - s)). apply D; split; lra. auto_derive; auto.
    * unfold scal; simpl; unfold mult; simpl. ring.
  + intros s Hs. rewrite Rabs_Ropp. specialize (H (2 * t0 - s) ltac:(lra)).
    rewrite (Rabs_left1 (2 * t0 - s - t0)) in H by lra. replace (- (2 * t0 - s - t0)) with (s - t0) in H by ring.
    exact H.
Qed.

Lemma segment_near t0 t s : segment t0 t s -> Rabs (s - t0) <= Rabs (t - t0).
Proof.
unfold segment, Rmin, Rmax. destruct Rle_dec; intros H; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(** Hence x^n/n! tends to 0, and so do the tails of the sum. *)
Lemma exp_series_tail x : ex_series (fun n => x ^ n / INR (fact n)).
Proof.
exists (exp x). generalize (is_exp_Reals x). apply is_series_ext.
intros n. rewrite pow_n_pow. reflexivity.
Qed.

Section Problem.
Variables (I : Type) (all : list I).
Hypothesis Hall : forall i, In i all.
Variable f : I -> R -> (I -> R) -> R.
Hypothesis f_continuous : forall x : I -> R -> R, (forall i t, continuous (x i) t) ->
  forall i t, continuous (fun s => f i s (fun j => x j s)) t.
Variable t0 : R.
Hypothesis f_lipschitz : forall r, exists L, 0 <= L /\ forall s, Rabs (s - t0) <= r -> forall x x' c,
  (forall j, Rabs (x j - x' j) <= c) -> forall i, Rabs (f i s x - f i s x') <= L * c.

(** Finitely many continuous functions are bounded together on a compact interval. *)
Lemma common_bound (g : I -> R -> R) lo hi : (forall i t, lo <= t <= hi -> continuous (g i) t) ->
  exists M, 0 <= M /\ forall i t, lo <= t <= hi -> Rabs (g i t) <= M.
Proof.
intros Hg. destruct (Rle_dec lo hi) as [Hl|Hl].
2: { exists 0. split. lra. intros i t Ht. lra. }
assert (B : forall i, exists M, forall t, lo <= t <= hi -> Rabs (g i t) <= M).
{ intros i. destruct (continuity_ab_maj (fun t => Rabs (g i t)) lo hi Hl) as (m & Hm & _).
  - intros t Ht. apply continuity_pt_filterlim, continuous_Rabs_comp. auto.
  - exists (Rabs (g i m)). exact Hm. }
assert (A : exists M, 0 <= M /\ forall i t, In i all -> lo <= t <= hi -> Rabs (g i t) <= M).
{ clear Hall. induction all as [|j l IH].
  - exists 0. split. lra. intros i t [].
  - destruct IH as (M & HM & H). destruct (B j) as (M' & H').
    exists (Rmax M M'). split. eapply Rle_trans; [exact HM|apply Rmax_l].
    intros i t [<-|Hi] Ht. eapply Rle_trans; [apply H', Ht|apply Rmax_r].
    eapply Rle_trans; [apply H; auto|apply Rmax_l]. }
destruct A as (M & HM & H). exists M. split; auto.
Qed.

(** ** Uniqueness *)
Theorem solution_unique (x x' : I -> R -> R) t :
  (forall i s, segment t0 t s -> is_derive (x i) s (f i s (fun j => x j s))) ->
  (forall i s, segment t0 t s -> is_derive (x' i) s (f i s (fun j => x' j s))) ->
  (forall i, x i t0 = x' i t0) -> forall i, x i t = x' i t.
Proof.
intros D D' E0 i.
destruct (common_bound (fun i s => x i s - x' i s) (Rmin t0 t) (Rmax t0 t)) as (M & HM & HB).
{ intros j s Hs. apply (ex_derive_continuous (fun s => x j s - x' j s)).
  eexists. apply (is_derive_minus (x j) (x' j)); [apply D|apply D']; exact Hs. }
destruct (f_lipschitz (Rabs (t - t0))) as (L & HL0 & HL).
assert (G : forall n s, segment t0 t s -> forall i, Rabs (x i s - x' i s) <= M * L ^ n * Rabs (s - t0) ^ n / INR
  (fact n)).
{ induction n as [|n IH]; intros s Hs j.
  - simpl. replace (M * 1 * 1 / 1) with M by field. exact (HB j s Hs).
  - assert (Sub : forall u, segment t0 s u -> segment t0 t u).
    { intros u Hu. revert Hs Hu. unfold segment, Rmin, Rmax. repeat destruct Rle_dec; lra. }
    replace (x j s - x' j s) with ((fun s => x j s - x' j s) s - (fun s => x j s - x' j s) t0)
      by (cbv beta; rewrite (E0 j); ring).
    apply (power_bound (fun s => x j s - x' j s) (fun s => f j s (fun i => x i s) - f j s (fun i => x' i s))).
    + intros u Hu. apply (is_derive_minus (x j) (x' j)); [apply D|apply D']; auto.
    + intros u Hu. replace (M * L ^ S n * Rabs (u - t0) ^ n / INR (fact n))
        with (L * (M * L ^ n * Rabs (u - t0) ^ n / INR (fact n))) by (simpl; unfold Rdiv; ring).
      apply HL. apply segment_near; auto. intros k. apply IH; auto. }
apply Rminus_diag_uniq, Rabs_eq_0, Rle_antisym; [|apply Rabs_pos].
assert (Lim0 := ex_series_lim_0 _ (exp_series_tail (L * Rabs (t - t0)))).
assert (B : segment t0 t t) by (unfold segment; split; [apply Rmin_r|apply Rmax_r]).
apply (is_lim_seq_le (fun _ => Rabs (x i t - x' i t)) (fun n => M * ((L * Rabs (t - t0)) ^ n / INR (fact n)))
  (Rabs (x i t - x' i t)) 0).
- intros n. rewrite Rpow_mult_distr.
  replace (M * (L ^ n * Rabs (t - t0) ^ n / INR (fact n))) with (M * L ^ n * Rabs (t - t0) ^ n / INR (fact n))
    by (unfold Rdiv; ring).
  apply G, B.
- apply is_lim_seq_const.
- replace 0 with (M * 0) by ring. apply (is_lim_seq_scal_l _ M 0), Lim0.
Qed.

(** ** Existence *)
Variable x0 : I -> R.

Fixpoint iterate (n : nat) (i : I) (t : R) : R :=
  match n with
  | O => x0 i
  | S n => x0 i + RInt (fun s => f i s (fun j => iterate n j s)) t0 t
  end.

Lemma iterate_derive_of n : (forall i t, continuous (iterate n i) t) ->
  forall i t, is_derive (iterate (S n) i) t (f i t (fun j => iterate n j t)).
Proof.
intros Hc i t. simpl. eapply is_derive_val.
- apply (is_derive_plus (fun _ => x0 i)). apply (is_derive_const (x0 i)).
  apply (is_derive_RInt (fun s => f i s (fun j => iterate n j s)) _ t0).
  + apply filter_forall. intros u.
    apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros s _.
    apply f_continuous, Hc.
  + apply f_continuous, Hc.
- apply plus_zero_l.
Qed.

Lemma iterate_continuous n : forall i t, continuous (iterate n i) t.
Proof.
induction n as [|n IH]; intros i t.
- apply continuous_const.
- apply (ex_derive_continuous (iterate (S n) i)). eexists. apply iterate_derive_of, IH.
Qed.

Lemma iterate_derive n i t : is_derive (iterate (S n) i) t (f i t (fun j => iterate n j t)).
Proof. apply iterate_derive_of, iterate_continuous. Qed.

Lemma iterate_start n i : iterate n i t0 = x0 i.
Proof. destruct n; simpl; auto. rewrite RInt_point. exact (Rplus_0_r (x0 i)). Qed.

Lemma iterate_step r : exists M L, 0 <= M /\ 0 <= L /\ forall n i t, Rabs (t - t0) <= r ->
  Rabs (iterate (S n) i t - iterate n i t) <= M * L ^ n * Rabs (t - t0) ^ S n / INR (fact (S n)).
Proof.
destruct (f_lipschitz r) as (L & HL0 & HL).
destruct (common_bound (fun i s => f i s x0) (t0 - r) (t0 + r)) as (M & HM & HB).
{ intros i t _. apply (f_continuous (fun j _ => x0 j)). intros j s. apply continuous_const. }
exists M, L. refine (conj HM (conj HL0 _)).
induction n as [|n IH]; intros i t Ht.
- replace (iterate 1 i t - iterate 0 i t) with (iterate 1 i t - iterate 1 i t0) by (rewrite iterate_start; reflexivity).
  replace (M * L ^ 0) with M by (simpl; ring).
  apply (power_bound _ (fun s => f i s x0)).
  + intros s _. apply (iterate_derive 0).
  + intros s Hs. simpl. replace (M * 1 / 1) with M by field. apply HB.
    apply segment_near in Hs. assert (Hr : Rabs (s - t0) <= r) by lra. apply Rabs_le_between in Hr. lra.
- replace (iterate (S (S n)) i t - iterate (S n) i t) with
    ((fun s => iterate (S (S n)) i s - iterate (S n) i s) t - (fun s => iterate (S (S n)) i s - iterate (S n) i s) t0)
    by (cbv beta; rewrite !iterate_start; ring).
  apply (power_bound (fun s => iterate (S (S n)) i s - iterate (S n) i s)
    (fun s => f i s (fun j => iterate (S n) j s) - f i s (fun j => iterate n j s))).
  + intros s _. apply (is_derive_minus (iterate (S (S n)) i) (iterate (S n) i)); apply iterate_derive.
  + intros s Hs. apply segment_near in Hs.
    replace (M * L ^ S n * Rabs (s - t0) ^ S n / INR (fact (S n)))
      with (L * (M * L ^ n * Rabs (s - t0) ^ S n / INR (fact (S n)))) by (simpl; unfold Rdiv; ring).
    apply HL. lra. intros j. apply IH. lra.
Qed.

(** The iterates with n >= 1 form a Cauchy sequence, uniformly in i and |t - t0| <= r. *)
Lemma iterate_cauchy r : exists rest : nat -> R, is_lim_seq rest 0 /\
  forall n m i t, Rabs (t - t0) <= r -> (n <= m)%nat -> Rabs (iterate (S m) i t - iterate (S n) i t) <= rest n.
Proof.
destruct (iterate_step r) as (M & L & HM & HL & H).
destruct (Rlt_dec r 0) as [Hr|Hr].
{ exists (fun _ => 0). split. apply is_lim_seq_const. intros n m i t Ht. generalize (Rabs_pos (t - t0)). lra. }
set (A := fun k => M * r * ((L * r) ^ k / INR (fact k))).
assert (HA : forall k, 0 <= A k).
{ intros k. unfold A. apply Rmult_le_pos. nra. apply Rmult_le_pos. apply pow_le; nra.
  apply Rlt_le, Rinv_0_lt_compat, INR_fact_lt_0. }
assert (XA : ex_series A) by exact (ex_series_scal (V := R_NormedModule) (M * r) _ (exp_series_tail (L * r))).
assert (Step : forall k i t, Rabs (t - t0) <= r -> Rabs (iterate (S k) i t - iterate k i t) <= A k).
{ intros k i t Ht. eapply Rle_trans. apply H, Ht.
  unfold A. rewrite fact_simpl, mult_INR, Rpow_mult_distr.
  assert (Hf := INR_fact_lt_0 k). assert (Hk := lt_0_INR (S k) (Nat.lt_0_succ k)).
  assert (H1 : 1 <= INR (S k)) by (rewrite S_INR; generalize (pos_INR k); lra).
  replace (M * L ^ k * Rabs (t - t0) ^ S k / (INR (S k) * INR (fact k)))
    with (M * L ^ k / INR (fact k) * (Rabs (t - t0) ^ S k * / INR (S k))) by (field; lra).
  replace (M * r * (L ^ k * r ^ k / INR (fact k))) with (M * L ^ k / INR (fact k) * (r ^ S k * 1))
    by (simpl; field; lra).
  apply Rmult_le_compat_l.
  - apply Rmult_le_pos. apply Rmult_le_pos; auto. apply pow_le, HL. apply Rlt_le, Rinv_0_lt_compat, Hf.
  - apply Rmult_le_compat. apply pow_le, Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hk.
    apply pow_incr. split; [apply Rabs_pos|exact Ht]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
exists (fun n => Series A - sum_n A n). split.
- replace (Finite 0) with (Finite (Series A - Series A)) by (f_equal; ring).
  apply is_lim_seq_minus'. apply is_lim_seq_const. apply Series_correct, XA.
- intros n m i t Ht Hnm. apply Rle_trans with (sum_n A m - sum_n A n).
  + induction Hnm as [|m Hnm IH].
    * rewrite !Rminus_eq_0, Rabs_R0. apply Rle_refl.
    * assert (E : sum_n A (S m) = sum_n A m + A (S m)) by exact (sum_Sn A m).
      specialize (Step (S m) i t Ht). rewrite E.
      replace (iterate (S (S m)) i t - iterate (S n) i t) with
        ((iterate (S (S m)) i t - iterate (S m) i t) + (iterate (S m) i t - iterate (S n) i t)) by ring.
      eapply Rle_trans. apply Rabs_triang. lra.
  + apply Rplus_le_compat_r.
    apply (is_lim_seq_incr_compare (sum_n A)). apply Series_correct, XA.
    intros k. assert (E : sum_n A (S k) = sum_n A k + A (S k)) by exact (sum_Sn A k). generalize (HA (S k)). lra.
Qed.

Definition solution (i : I) (t : R) : R := Lim_seq (fun n => iterate (S n) i t).

Lemma iterate_limit r : exists rest : nat -> R, is_lim_seq rest 0 /\
  forall n i t, Rabs (t - t0) <= r -> Rabs (solution i t - iterate (S n) i t) <= rest n.
Proof.
destruct (iterate_cauchy r) as (rest & Hrest & HC). exists rest. split; auto.
intros n i t Ht.
assert (XL : ex_finite_lim_seq (fun n => iterate (S n) i t)).
{ apply ex_lim_seq_cauchy_corr. intros d. apply is_lim_seq_spec in Hrest. destruct (Hrest d) as [N HN].
  exists N. intros k m Hk Hm.
  assert (Small : forall k m, (N <= k)%nat -> (k <= m)%nat -> Rabs (iterate (S m) i t - iterate (S k) i t) < d).
  { intros a b Ha Hab. specialize (HN a Ha). rewrite Rminus_0_r in HN.
    generalize (HC a b i t Ht Hab) (Rle_abs (rest a)). lra. }
  destruct (Nat.le_ge_cases k m) as [Hkm|Hkm]. rewrite Rabs_minus_sym. all: auto. }
apply Lim_seq_correct' in XL. fold (solution i t) in XL.
apply (is_lim_seq_le_loc (fun m => Rabs (iterate (S m) i t - iterate (S n) i t)) (fun _ => rest n)
  (Rabs (solution i t - iterate (S n) i t)) (rest n)).
- exists n. intros m Hm. apply HC; auto.
- apply (is_lim_seq_abs _ (solution i t - iterate (S n) i t)). apply is_lim_seq_minus'. exact XL.
  apply is_lim_seq_const.
- apply is_lim_seq_const.
Qed.

Theorem solution_derive i t : is_derive (solution i) t (f i t (fun j => solution j t)).
Proof.
set (r := Rabs (t - t0) + 1).
destruct (iterate_limit r) as (rest & Hrest & HL).
destruct (f_lipschitz r) as (L & HL0 & Hlip).
set (fn := fun n => iterate (S (S n)) i).
set (D := fun s => t0 - r < s < t0 + r).
assert (DR : forall s, D s -> Rabs (s - t0) <= r).
{ intros s Hs. unfold D in Hs. apply Rabs_le. lra. }
assert (Shift : forall s, Lim_seq (fun n => fn n s) = Lim_seq (fun n => iterate (S n) i s)).
{ intros s. exact (Lim_seq_incr_1 (fun n => iterate (S n) i s)). }
assert (Dfn : forall n s, Derive (fn n) s = f i s (fun j => iterate (S n) j s)).
{ intros n s. apply is_derive_unique, iterate_derive. }
assert (Rate : forall n s, D s -> Rabs (f i s (fun j => iterate (S n) j s) - f i s (fun j => solution j s))
  <= L * rest n).
{ intros n s Hs. apply Hlip. apply DR, Hs. intros j. rewrite Rabs_minus_sym. apply HL, DR, Hs. }
assert (RateLim : is_lim_seq (fun n => L * rest n) 0).
{ replace (Finite 0) with (Finite (L * 0)) by (f_equal; ring). apply (is_lim_seq_scal_l rest L 0), Hrest. }
assert (DLim : forall s, D s -> Lim_seq (fun n => Derive (fn n) s) = f i s (fun j => solution j s)).
{ intros s Hs. apply is_lim_seq_unique.
  apply (is_lim_seq_ext (fun n => f i s (fun j => iterate (S n) j s))). { intros n. symmetry. apply Dfn. }
  apply is_lim_seq_spec. intros d. apply is_lim_seq_spec in RateLim. destruct (RateLim d) as [N HN].
  exists N. intros n Hn. specialize (HN n Hn). rewrite Rminus_0_r in HN.
  generalize (Rate n s Hs) (Rle_abs (L * rest n)). lra. }
assert (Dt : D t). { unfold D, r. generalize (Rle_abs (t - t0)) (Rle_abs (- (t - t0))). rewrite Rabs_Ropp. lra. }
apply (is_derive_ext (fun s => real (Lim_seq (fun n => fn n s)))). { intros s. rewrite Shift. reflexivity. }
replace (f i t (fun j => solution j t)) with (real (Lim_seq (fun n => Derive (fn n) t))) by (rewrite DLim; auto).
apply (CVU_Derive fn D).
- apply open_and. apply (open_gt (t0 - r)). apply (open_lt (t0 + r)).
- intros a b x Ha Hb Hx. unfold D in *. lra.
- intros d. apply is_lim_seq_spec in Hrest. destruct (Hrest d) as [N HN]. exists N. intros n Hn s Hs.
  rewrite Shift. change (real (Lim_seq (fun n => iterate (S n) i s))) with (solution i s).
  rewrite Rabs_minus_sym. specialize (HN (S n) ltac:(lia)). rewrite Rminus_0_r in HN.
  generalize (HL (S n) i s (DR s Hs)) (Rle_abs (rest (S n))). unfold fn. lra.
- intros n s _. eexists. apply iterate_derive.
- intros n s _. apply continuity_pt_filterlim.
  apply (continuous_ext (fun s => f i s (fun j => iterate (S n) j s))). { intros u. symmetry. apply Dfn. }
  apply f_continuous. intros j u. apply iterate_continuous.
- intros d. apply is_lim_seq_spec in RateLim. destruct (RateLim d) as [N HN]. exists N. intros n Hn s Hs.
  rewrite (DLim s Hs), Dfn. specialize (HN n Hn). rewrite Rminus_0_r in HN.
  generalize (Rate n s Hs) (Rle_abs (L * rest n)). intros A1 A2.
  eapply Rle_lt_trans; [exact A1|]. lra.
- exact Dt.
Qed.

Lemma solution_start i : solution i t0 = x0 i.
Proof.
unfold solution. rewrite (Lim_seq_ext _ (fun _ => x0 i)). rewrite Lim_seq_const; reflexivity.
intros n. apply iterate_start.
Qed.

Theorem solution_exists : exists x : I -> R -> R, (forall i, x i t0 = x0 i) /\
  forall i t, is_derive (x i) t (f i t (fun j => x j t)).
Proof. exists solution. split. exact solution_start. exact solution_derive. Qed.

End Problem.
