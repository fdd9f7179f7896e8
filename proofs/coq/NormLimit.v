(** * Limits of power series of bounded norm

    A pointwise limit of functions with [norm_at_most] is one, with the limit of the bounds ([norm_limit]): the
    coefficients converge one after the other. Hence sums of series ([norm_series]), integrals over a segment
    ([norm_integral]) and over (0, oo) ([norm_improper]), 1/(1 - f) and exp. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncationLimit PowerSeriesNorm.
Open Scope R_scope.

Section Limit.
Context {T : Type} {Fl : (T -> Prop) -> Prop} {PF : ProperFilter Fl}.

Definition tends (u : T -> R) (l : R) : Prop := filterlim u Fl (locally l).

Lemma tends_spec u l : tends u l <-> forall eps : posreal, Fl (fun k => Rabs (u k - l) < eps).
Proof. unfold tends. rewrite filterlim_locally. reflexivity. Qed.

Lemma tends_const c : tends (fun _ => c) c.
Proof. apply filterlim_const. Qed.

Lemma tends_plus u v l k : tends u l -> tends v k -> tends (fun t => u t + v t) (l + k).
Proof. intros Hu Hv. apply (filterlim_comp_2 (G := locally l) (H := locally k) u v Rplus Hu Hv).
apply (filterlim_plus (V := R_NormedModule)). Qed.

Lemma tends_scal c u l : tends u l -> tends (fun t => c * u t) (c * l).
Proof.
intros Hu. apply (filterlim_comp _ _ _ u (fun z => c * z) Fl (locally l)); auto.
apply (continuous_scal_r c (fun z => z) l (V := R_NormedModule)), continuous_id.
Qed.

Lemma tends_abs u l : tends u l -> tends (fun t => Rabs (u t)) (Rabs l).
Proof. intros Hu. apply (filterlim_comp _ _ _ u Rabs Fl (locally l)); auto. apply (continuous_abs (K := R_AbsRing)).
Qed.

Lemma tends_minus u v l k : tends u l -> tends v k -> tends (fun t => u t - v t) (l - k).
Proof.
intros Hu Hv. assert (H := tends_plus _ _ _ _ Hu (tends_scal (-1) _ _ Hv)).
replace (l - k) with (l + -1 * k) by ring.
apply (filterlim_ext (fun t => u t + -1 * v t)); auto. intros t. ring.
Qed.

Lemma tends_sum (u : T -> nat -> R) (l : nat -> R) N : (forall n, (n < N)%nat -> tends (fun t => u t n) (l n)) ->
  tends (fun t => sum_first (u t) N) (sum_first l N).
Proof.
induction N as [|N IH]; intros H; simpl.
- apply tends_const.
- apply (tends_plus (fun t => sum_first (u t) N) (fun t => u t N)). apply IH. intros; apply H; lia. apply H; lia.
Qed.

Lemma tends_le u v l k : Fl (fun t => u t <= v t) -> tends u l -> tends v k -> l <= k.
Proof. intros H Hu Hv. apply (filterlim_le (F := Fl) u v (Finite l) (Finite k) H Hu Hv). Qed.

Variables (f : T -> R -> R) (g : R -> R) (m : T -> R) (r M : R).
Hypothesis Hr : 0 < r.
Hypothesis Hf : Fl (fun k => norm_at_most r (m k) (f k)).
Hypothesis Hm : tends m M.
Hypothesis Hg : forall x, Rabs x < r -> tends (fun k => f k x) (g x).

Let A k n := taylor (f k) n.

Lemma near_limit : Fl (fun k => (forall N, sum_first (fun n => Rabs (A k n) * r ^ n) N <= m k) /\ forall x,
  Rabs x < r -> is_pseries (A k) x (f k x)).
Proof. eapply filter_imp; [|exact Hf]. intros k Hk. apply taylor_coefficients; auto. Qed.

Lemma near_limit_tail x N : Rabs x < r ->
  Fl (fun k => Rabs (f k x - sum_first (fun n => A k n * x ^ n) N) <= m k * (Rabs x / r) ^ N).
Proof.
intros Hx. eapply filter_imp; [|exact near_limit]. intros k [H1 H2]. apply (series_tail (A k) r (m k) Hr H1); auto. lra.
Qed.

Let l n := lim (filtermap (fun k => A k n) Fl) : R.

Lemma limit_bound_nonneg : 0 <= M.
Proof.
apply (tends_le (fun _ => 0) m); auto; [|apply tends_const].
eapply filter_imp; [|exact Hf]. intros k Hk. exact (norm_bound_nonneg _ _ _ Hk).
Qed.

Lemma coefficients_tend n : tends (fun k => A k n) (l n).
Proof.
induction n as [n IH] using lt_wf_ind.
apply filterlim_locally.
apply (complete_cauchy (T := R_CompleteSpace) (filtermap (fun k => A k n) Fl)); [apply filtermap_proper_filter, PF|].
intros eps.
assert (HM := limit_bound_nonneg). set (C := M + 1).
assert (P : 0 < r ^ S n) by (apply pow_lt, Hr). assert (He := cond_pos eps).
set (x := Rmin (r / 2) (eps / 2 * r ^ S n / (2 * C))).
assert (Hx0 : 0 < x). { apply Rmin_pos. lra. apply Rdiv_lt_0_compat. apply Rmult_lt_0_compat; lra. unfold C; lra. }
assert (Hx1 : x <= r / 2) by apply Rmin_l. assert (Hx2 : x <= eps / 2 * r ^ S n / (2 * C)) by apply Rmin_r.
assert (AX : Rabs x = x) by (apply Rabs_pos_eq; lra).
assert (Px : 0 < x ^ n) by (apply pow_lt, Hx0).
exists (/ x ^ n * (g x - sum_first (fun n => l n * x ^ n) n)).
assert (L : tends (fun k => / x ^ n * (f k x - sum_first (fun n => A k n * x ^ n) n))
  (/ x ^ n * (g x - sum_first (fun n => l n * x ^ n) n))).
{ apply tends_scal, tends_minus. apply Hg; lra. apply (tends_sum (fun k n => A k n * x ^ n) (fun n => l n * x ^ n)).
  intros i Hi. apply (filterlim_ext (fun k => x ^ i * A k i)). intros k. ring. rewrite Rmult_comm.
  apply tends_scal, IH, Hi. }
assert (He2 : 0 < eps / 2) by lra.
assert (L' := proj1 (tends_spec _ _) L (mkposreal _ He2)).
assert (Lm := proj1 (tends_spec _ _) Hm (mkposreal 1 Rlt_0_1)).
unfold filtermap.
eapply filter_imp; [|exact (filter_and _ _ L' (filter_and _ _ Lm (near_limit_tail x (S n) ltac:(lra))))].
intros k (H1 & H2 & H3). cbn [pos] in *. cbn [sum_first] in H3. rewrite AX in H3.
set (q := / x ^ n * (g x - sum_first (fun n => l n * x ^ n) n)) in *.
set (s := sum_first (fun n => A k n * x ^ n) n) in *.
change (Rabs (A k n - q) < eps).
assert (E : A k n - / x ^ n * (f k x - s) = - (/ x ^ n * (f k x - (s + A k n * x ^ n)))) by (field; lra).
assert (B : Rabs (A k n - / x ^ n * (f k x - s)) <= eps / 2).
{ rewrite E, Rabs_Ropp, Rabs_mult, Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat, Px).
  apply Rmult_le_reg_l with (x ^ n); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
  eapply Rle_trans; [exact H3|].
  apply Rle_trans with (C * (x / r) ^ S n).
  - apply Rmult_le_compat_r. apply pow_le. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, Hr.
    apply Rabs_def2 in H2. unfold C. lra.
  - rewrite pow_quotient. change (x ^ S n) with (x * x ^ n).
    replace (C * (x * x ^ n / r ^ S n)) with (x ^ n * (C * x / r ^ S n)) by (field; lra).
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_reg_r with (r ^ S n); auto.
    replace (C * x / r ^ S n * r ^ S n) with (C * x) by (field; lra).
    assert (HC : 0 < C) by (unfold C; lra).
    apply (Rmult_le_compat_l C) in Hx2; [|lra].
    replace (C * (eps / 2 * r ^ S n / (2 * C))) with (eps / 2 * r ^ S n / 2) in Hx2 by (field; lra).
    assert (0 < eps / 2 * r ^ S n) by (apply Rmult_lt_0_compat; lra). lra. }
replace (A k n - q) with ((A k n - / x ^ n * (f k x - s)) + (/ x ^ n * (f k x - s) - q)) by ring.
eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
Qed.

Theorem norm_limit : norm_at_most r M g.
Proof.
exists l. split.
- intros N. apply (tends_le (fun k => sum_first (fun n => Rabs (A k n) * r ^ n) N) m); auto.
  + eapply filter_imp; [|exact near_limit]. intros k [H _]. apply H.
  + apply (tends_sum (fun k n => Rabs (A k n) * r ^ n) (fun n => Rabs (l n) * r ^ n)). intros n _.
    apply (filterlim_ext (fun k => r ^ n * Rabs (A k n))). intros k. ring. rewrite Rmult_comm.
    apply tends_scal, tends_abs, coefficients_tend.
- intros x Hx. apply is_pseries_sum_first.
  assert (B : forall N, Rabs (g x - sum_first (fun n => l n * x ^ n) N) <= M * (Rabs x / r) ^ N).
  { intros N. apply (tends_le (fun k => Rabs (f k x - sum_first (fun n => A k n * x ^ n) N)) (fun k =>
      m k * (Rabs x / r) ^ N)).
    - apply near_limit_tail, Hx.
    - apply tends_abs, tends_minus; auto. apply (tends_sum (fun k n => A k n * x ^ n) (fun n => l n * x ^ n)).
      intros n _.
      apply (filterlim_ext (fun k => x ^ n * A k n)). intros k. ring. rewrite Rmult_comm.
      apply tends_scal, coefficients_tend.
    - apply (filterlim_ext (fun k => (Rabs x / r) ^ N * m k)). intros k. ring. rewrite Rmult_comm.
      apply tends_scal, Hm. }
  assert (Q : Rabs (Rabs x / r) < 1).
  { rewrite Rabs_pos_eq. apply Rmult_lt_reg_r with r; auto. replace (Rabs x / r * r) with (Rabs x) by (field; lra). lra.
    apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hr. }
  assert (Z : is_lim_seq (fun N => M * (Rabs x / r) ^ N) 0).
  { replace (Finite 0) with (Rbar_mult M 0) by (simpl; f_equal; ring).
    apply (is_lim_seq_scal_l _ M 0), is_lim_seq_geom, Q. }
  apply (is_lim_seq_le_le (fun N => g x - M * (Rabs x / r) ^ N) _ (fun N => g x + M * (Rabs x / r) ^ N)).
  + intros N. specialize (B N). apply Rabs_le_between in B. lra.
  + replace (Finite (g x)) with (Finite (g x - 0)) by (f_equal; ring). apply is_lim_seq_minus'; auto.
    apply is_lim_seq_const.
  + replace (Finite (g x)) with (Finite (g x + 0)) by (f_equal; ring). apply is_lim_seq_plus'; auto.
    apply is_lim_seq_const.
Qed.
End Limit.

(** ** Series, 1/(1 - f), exp *)

Lemma norm_sum_first r (f : nat -> R -> R) (m : nat -> R) N : 0 < r -> (forall j, norm_at_most r (m j) (f j)) ->
  norm_at_most r (sum_first m N) (fun x => sum_first (fun j => f j x) N).
Proof.
intros Hr H. induction N as [|N IH]; simpl.
- apply (norm_weaken r (Rabs 0)). rewrite Rabs_R0; lra. apply norm_const.
- apply (norm_plus r _ _ (fun x => sum_first (fun j => f j x) N) (f N)); auto.
Qed.

Lemma norm_series r (f : nat -> R -> R) (m : nat -> R) M (s : R -> R) : 0 < r ->
  (forall j, norm_at_most r (m j) (f j)) ->
  (forall N, sum_first m N <= M) -> (forall x, Rabs x < r -> is_lim_seq (fun N => sum_first (fun j => f j x) N)
    (s x)) ->
  norm_at_most r M s.
Proof.
intros Hr Hf Hm Hs.
apply (norm_limit (Fl := eventually) (fun N x => sum_first (fun j => f j x) N) s (fun _ => M) r M Hr).
- apply filter_forall. intros N. apply (norm_weaken _ _ _ _ (Hm N)). apply norm_sum_first; auto.
- apply tends_const.
- intros x Hx. apply (Hs x Hx).
Qed.

Lemma sum_geometric q N : 0 <= q < 1 -> sum_first (fun j => q ^ j) N <= / (1 - q).
Proof.
intros Hq. assert (E : sum_first (fun j => q ^ j) N = (1 - q ^ N) / (1 - q)).
{ induction N as [|N IH]; simpl. field. lra. rewrite IH. field. lra. }
rewrite E. assert (0 <= q ^ N) by (apply pow_le; lra). unfold Rdiv. rewrite <- (Rmult_1_l (/ (1 - q))) at 2.
apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat|]; lra.
Qed.

Lemma norm_geometric r q f : 0 < r -> q < 1 -> norm_at_most r q f -> norm_at_most r (/ (1 - q)) (fun x => / (1 - f x)).
Proof.
intros Hr Hq Hf. assert (Q := norm_bound_nonneg _ _ _ Hf).
apply (norm_series r (fun j x => f x ^ j) (fun j => q ^ j) _ _ Hr).
- intros j. apply norm_pow; auto.
- intros N. apply sum_geometric; lra.
- intros x Hx. assert (V := norm_value r q f x Hr Hf Hx).
  apply is_lim_seq_incr_1. apply (is_lim_seq_ext (sum_n (fun j => f x ^ j))). intros N. apply sum_first_sum_n.
  apply (is_series_geom (f x)). lra.
Qed.

Lemma norm_exp r c : 0 < r -> norm_at_most r (exp (Rabs c * r)) (fun x => exp (c * x)).
Proof.
intros Hr.
assert (E : forall x, is_lim_seq (fun N => sum_first (fun n => / INR (fact n) * x ^ n) N) (exp x)).
{ intros x. apply is_pseries_sum_first, is_exp_Reals. }
exists (fun n => / INR (fact n) * c ^ n). 
assert (P : forall n, 0 < / INR (fact n)) by (intros; apply Rinv_0_lt_compat, lt_0_INR, lt_O_fact).
split.
- intros N. rewrite (sum_first_ext _ (fun n => / INR (fact n) * (Rabs c * r) ^ n)).
  + apply (is_lim_seq_incr_compare _ _ (E (Rabs c * r))). intros n. simpl.
    assert (0 <= / INR (fact n) * (Rabs c * r) ^ n); [|lra]. apply Rmult_le_pos. apply Rlt_le, P.
    apply pow_le, Rmult_le_pos; [apply Rabs_pos|lra].
  + intros n. rewrite Rabs_mult, <- RPow_abs, Rpow_mult_distr, Rabs_pos_eq by (apply Rlt_le, P). ring.
- intros x _. apply is_pseries_sum_first.
  apply (is_lim_seq_ext (fun N => sum_first (fun n => / INR (fact n) * (c * x) ^ n) N)).
  + intros N. apply sum_first_ext. intros n. rewrite Rpow_mult_distr. ring.
  + apply E.
Qed.

(** ** Integrals with a parameter *)

Lemma norm_Riemann_sum r (f : R -> R -> R) (m : R -> R) ptd : 0 < r -> (forall s, norm_at_most r (m s) (f s)) ->
  pointed_subdiv ptd ->
  norm_at_most r (Riemann_sum m ptd) (fun x => Riemann_sum (fun s => f s x) ptd).
Proof.
intros Hr Hf. induction ptd as [h|h ptd IH] using SF_cons_ind; intros Hp.
- apply (norm_weaken r (Rabs 0)). rewrite Rabs_R0. apply Rle_refl. apply norm_const.
- assert (H0 := Hp 0%nat ltac:(rewrite SF_size_cons; apply Nat.lt_0_succ)). simpl in H0.
  assert (Hh : fst h <= SF_h ptd) by (destruct ptd as [h' t']; simpl in *; lra).
  apply (norm_ext r _ (fun x => (SF_h ptd - fst h) * f (snd h) x + Riemann_sum (fun s => f s x) ptd)).
  { intros x _. rewrite Riemann_sum_cons. reflexivity. }
  rewrite Riemann_sum_cons. apply (norm_plus r ((SF_h ptd - fst h) * m (snd h))); auto.
  + rewrite <- (Rabs_pos_eq (SF_h ptd - fst h)) at 1 by lra. apply norm_scal, Hf.
  + apply IH. apply (ptd_cons h), Hp.
Qed.

Lemma norm_integral r (f : R -> R -> R) (m : R -> R) a d (g : R -> R) M : 0 < r -> a < d ->
  (forall s, norm_at_most r (m s) (f s)) ->
  is_RInt m a d M -> (forall x, Rabs x < r -> is_RInt (fun s => f s x) a d (g x)) -> norm_at_most r M g.
Proof.
intros Hr Had Hf HM Hg.
assert (E : forall (h : R -> R) l, is_RInt h a d l -> filterlim (fun ptd => Riemann_sum h ptd) (Riemann_fine a d)
  (locally l)).
{ intros h l H. unfold is_RInt in H. rewrite sign_eq_1 in H by lra.
  apply (filterlim_ext (fun ptd => scal 1 (Riemann_sum h ptd))); auto. intros ptd.
  apply (scal_one (V := R_ModuleSpace)). }
apply (norm_limit (Fl := Riemann_fine a d) (fun ptd x => Riemann_sum (fun s => f s x) ptd) g (fun ptd =>
  Riemann_sum m ptd) r M Hr).
- unfold Riemann_fine, within. apply filter_forall. intros ptd (Hp & _). apply norm_Riemann_sum; auto.
- apply E, HM.
- intros x Hx. apply E, Hg, Hx.
Qed.

Lemma improper_tends (h : R -> R) l : (forall u, 0 < u -> continuous h u) ->
  is_RInt_gen h (at_right 0) (Rbar_locally p_infty) l ->
  filterlim (fun ad => RInt h (fst ad) (snd ad)) trunc (locally l).
Proof.
intros Hc H. unfold is_RInt_gen in H.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in H.
apply filterlim_locally. intros eps. eapply filter_imp; [|apply (H eps)].
intros [a d] (z & Hz & Hb). simpl in *. apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz. rewrite Hz.
exact Hb.
Qed.

Lemma norm_improper r (f : R -> R -> R) (m : R -> R) (g : R -> R) M : 0 < r -> (forall s, norm_at_most r (m s) (f s)) ->
  (forall s, 0 < s -> continuous m s) -> (forall x s, Rabs x < r -> 0 < s -> continuous (fun s => f s x) s) ->
  is_RInt_gen m (at_right 0) (Rbar_locally p_infty) M ->
  (forall x, Rabs x < r -> is_RInt_gen (fun s => f s x) (at_right 0) (Rbar_locally p_infty) (g x)) ->
    norm_at_most r M g.
Proof.
intros Hr Hf Cm Cf HM Hg.
assert (Ex : forall (h : R -> R) a d, 0 < a -> a <= d -> (forall s, 0 < s -> continuous h s) ->
  is_RInt h a d (RInt h a d)).
{ intros h a d Ha Hd Hc. apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous h).
  intros z Hz; rewrite Rmin_left in Hz by lra. apply Hc; lra. }
apply (norm_limit (Fl := trunc) (fun ad x => RInt (fun s => f s x) (fst ad) (snd ad)) g (fun ad =>
  RInt m (fst ad) (snd ad)) r M Hr).
- generalize trunc_basic. apply trunc_imp. intros [a d] [Ha Hd]; simpl in *.
  apply (norm_integral r f m a d); auto; try lra. apply Ex; auto; lra. intros x Hx. apply Ex; auto; try lra.
- apply improper_tends; auto.
- intros x Hx. apply improper_tends; auto.
Qed.
