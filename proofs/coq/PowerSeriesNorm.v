(** * Functions with a power series of bounded norm

    [norm_at_most r M f]: on |x| < r f is a power series a, and sum |a_n| r^n <= M. The bound is multiplicative; and it
    is kept by pointwise limits ([norm_limit]), whatever the filter: the coefficients converge, one after the other,
    because |f(x) - a_0 - ... - a_n x^n| <= M (|x|/r)^(n+1) for all functions of the family at once. So series,
    integrals with a parameter, improper integrals and limits of iterations are power series as soon as the norms of
    what approximates them are bounded. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus.
Open Scope R_scope.

Definition norm_at_most (r M : R) (f : R -> R) : Prop := exists a : nat -> R,
  (forall N, sum_first (fun n => Rabs (a n) * r ^ n) N <= M) /\ forall x, Rabs x < r -> is_pseries a x (f x).

(** ** Sums *)

Lemma sum_first_le u v N : (forall n, u n <= v n) -> sum_first u N <= sum_first v N.
Proof. intros H. induction N as [|N IH]; simpl. lra. specialize (H N). lra. Qed.

Lemma sum_first_ext u v N : (forall n, u n = v n) -> sum_first u N = sum_first v N.
Proof. intros H. induction N as [|N IH]; simpl; auto. rewrite IH, H. reflexivity. Qed.

Lemma sum_first_plus u v N : sum_first (fun n => u n + v n) N = sum_first u N + sum_first v N.
Proof. induction N as [|N IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma sum_first_scal c u N : sum_first (fun n => c * u n) N = c * sum_first u N.
Proof. induction N as [|N IH]; simpl. ring. rewrite IH. ring. Qed.

Lemma sum_first_nonneg u N : (forall n, 0 <= u n) -> 0 <= sum_first u N.
Proof. intros H. induction N as [|N IH]; simpl. lra. specialize (H N). lra. Qed.

Lemma sum_first_grow u N K : (forall n, 0 <= u n) -> sum_first u N <= sum_first u (N + K).
Proof. intros H. induction K as [|K IH]. rewrite Nat.add_0_r. lra. rewrite Nat.add_succ_r. simpl.
specialize (H (N + K)%nat). lra. Qed.

Lemma sum_first_abs u N : Rabs (sum_first u N) <= sum_first (fun n => Rabs (u n)) N.
Proof. induction N as [|N IH]; simpl. rewrite Rabs_R0. lra. eapply Rle_trans; [apply Rabs_triang|]. lra. Qed.

Lemma sum_first_sum_n u N : sum_n u N = sum_first u (S N).
Proof. induction N as [|N IH]. rewrite sum_O. symmetry. apply Rplus_0_l. rewrite sum_Sn, IH. reflexivity. Qed.

Lemma is_pseries_sum_first (a : nat -> R) (x s : R) : is_pseries a x s <->
  is_lim_seq (fun N => sum_first (fun n => a n * x ^ n) N) s.
Proof.
rewrite is_pseries_R. unfold is_series. rewrite (is_lim_seq_incr_1 (fun N => sum_first (fun n => a n * x ^ n) N)).
split; intros H.
- apply (is_lim_seq_ext (sum_n (fun n => a n * x ^ n))); [|exact H]. intros N. apply sum_first_sum_n.
- change (is_lim_seq (sum_n (fun n => a n * x ^ n)) s).
  apply (is_lim_seq_ext (fun N => sum_first (fun n => a n * x ^ n) (S N))); [|exact H]. intros N. symmetry.
  apply sum_first_sum_n.
Qed.

Lemma pow_quotient x r n : (x / r) ^ n = x ^ n / r ^ n.
Proof. unfold Rdiv. rewrite Rpow_mult_distr, pow_inv. reflexivity. Qed.

(** ** One series *)

Section Series.
Variables (a : nat -> R) (r M : R).
Hypothesis Hr : 0 < r.
Hypothesis HM : forall N, sum_first (fun n => Rabs (a n) * r ^ n) N <= M.

Let term n := Rabs (a n) * r ^ n.

Lemma term_nonneg n : 0 <= term n.
Proof. apply Rmult_le_pos. apply Rabs_pos. apply pow_le; lra. Qed.

Lemma norm_nonneg : 0 <= M.
Proof. exact (HM 0). Qed.

Lemma term_bound n : Rabs (a n) * r ^ n <= M.
Proof. assert (H := HM (S n)). simpl in H. assert (N := sum_first_nonneg term n term_nonneg). unfold term in N. lra.
Qed.

Lemma coefficient_bound n : Rabs (a n) <= M / r ^ n.
Proof.
assert (P : 0 < r ^ n) by (apply pow_lt, Hr). apply Rmult_le_reg_r with (r ^ n); auto.
replace (M / r ^ n * r ^ n) with M by (field; lra). apply term_bound.
Qed.

Lemma radius_at_least x : Rabs x < r -> Rbar_lt (Rabs x) (CV_radius a).
Proof.
intros Hx. apply Rbar_lt_le_trans with r; [exact Hx|].
apply (proj1 (CV_radius_bounded a)). exists M. intros n.
rewrite Rabs_mult, (Rabs_pos_eq (r ^ n)) by (apply pow_le; lra). apply term_bound.
Qed.

Lemma partial_tail x N K : Rabs x <= r ->
  Rabs (sum_first (fun n => a n * x ^ n) (N + K) - sum_first (fun n => a n * x ^ n) N)
    <= (Rabs x / r) ^ N * (sum_first term (N + K) - sum_first term N).
Proof.
intros Hx. induction K as [|K IH].
- rewrite Nat.add_0_r. unfold Rminus. rewrite !Rplus_opp_r, Rabs_R0. lra.
- rewrite Nat.add_succ_r. simpl.
  set (s := sum_first (fun n => a n * x ^ n)) in *.
  replace (s (N + K)%nat + a (N + K)%nat * x ^ (N + K) - s N) with (s (N + K)%nat - s N + a (N + K)%nat * x ^ (N + K))
    by ring.
  eapply Rle_trans; [apply Rabs_triang|].
  replace ((Rabs x / r) ^ N * (sum_first term (N + K) + term (N + K) - sum_first term N))
    with ((Rabs x / r) ^ N * (sum_first term (N + K) - sum_first term N) + (Rabs x / r) ^ N * term (N + K)) by ring.
  apply Rplus_le_compat; [exact IH|].
  assert (Q : 0 <= Rabs x / r). { apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hr. }
  assert (Q1 : Rabs x / r <= 1).
  { apply Rmult_le_reg_r with r; auto. replace (Rabs x / r * r) with (Rabs x) by (field; lra). lra. }
  rewrite Rabs_mult, <- RPow_abs. unfold term.
  replace (Rabs x ^ (N + K)) with ((Rabs x / r) ^ N * (Rabs x / r) ^ K * r ^ (N + K)).
  2: { rewrite !pow_add, !pow_quotient. field. split; apply pow_nonzero; lra. }
  assert (P1 := pow_le _ N Q). assert (P3 : (Rabs x / r) ^ K <= 1) by (rewrite <- (pow1 K); apply pow_incr; lra).
  replace (Rabs (a (N + K)%nat) * ((Rabs x / r) ^ N * (Rabs x / r) ^ K * r ^ (N + K)))
    with ((Rabs x / r) ^ N * (Rabs (a (N + K)%nat) * r ^ (N + K)) * (Rabs x / r) ^ K) by ring.
  rewrite <- (Rmult_1_r ((Rabs x / r) ^ N * (Rabs (a (N + K)%nat) * r ^ (N + K)))) at 2.
  apply Rmult_le_compat_l; auto. apply Rmult_le_pos; auto. apply term_nonneg.
Qed.

Lemma series_tail (x s : R) N : Rabs x <= r -> is_pseries a x s ->
  Rabs (s - sum_first (fun n => a n * x ^ n) N) <= M * (Rabs x / r) ^ N.
Proof.
intros Hx Hs. apply is_pseries_sum_first in Hs.
set (p := sum_first (fun n => a n * x ^ n)) in *.
assert (L : is_lim_seq (fun K => Rabs (p (K + N)%nat - p N)) (Rabs (s - p N))).
{ apply (is_lim_seq_abs (fun K => p (K + N)%nat - p N) (s - p N)). apply is_lim_seq_minus'; [|apply is_lim_seq_const].
  apply (is_lim_seq_incr_n p N). exact Hs. }
assert (B : forall K, Rabs (p (K + N)%nat - p N) <= M * (Rabs x / r) ^ N).
{ intros K. rewrite Nat.add_comm. eapply Rle_trans; [apply (partial_tail x N K Hx)|].
  rewrite Rmult_comm. apply Rmult_le_compat_r.
  - apply pow_le. apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Hr.
  - assert (H := HM (N + K)). assert (H0 := sum_first_nonneg term N term_nonneg). unfold term in *. lra. }
exact (is_lim_seq_le _ (fun _ => M * (Rabs x / r) ^ N) _ _ B L (is_lim_seq_const _)).
Qed.
End Series.

(** The coefficients are Taylor's. *)
Definition taylor (f : R -> R) (n : nat) : R := Derive_n f n 0 / INR (fact n).

Lemma taylor_coefficients r M f : 0 < r -> norm_at_most r M f ->
  (forall N, sum_first (fun n => Rabs (taylor f n) * r ^ n) N <= M) /\ forall x, Rabs x < r ->
    is_pseries (taylor f) x (f x).
Proof.
intros Hr (a & Ha & Hf).
assert (E : forall n, taylor f n = a n).
{ intros n. unfold taylor.
  rewrite (Derive_n_ext_loc f (PSeries a)).
  - rewrite Derive_n_coef. field. apply INR_fact_neq_0.
    rewrite <- Rabs_R0. apply (radius_at_least a r M Hr Ha). rewrite Rabs_R0. exact Hr.
  - exists (mkposreal r Hr). intros y Hy. change (Rabs (y - 0) < r) in Hy. rewrite Rminus_0_r in Hy.
    symmetry. apply is_pseries_unique, Hf, Hy. }
split.
- intros N. rewrite (sum_first_ext _ (fun n => Rabs (a n) * r ^ n)); auto. intros n. rewrite E. reflexivity.
- intros x Hx. apply (is_pseries_ext a); auto.
Qed.

(** ** The algebra *)

Lemma norm_value r M f x : 0 < r -> norm_at_most r M f -> Rabs x < r -> Rabs (f x) <= M.
Proof.
intros Hr (a & Ha & Hf) Hx.
assert (T := series_tail a r M Hr Ha x (f x) 0 ltac:(lra) (Hf x Hx)). simpl in T. rewrite Rminus_0_r, Rmult_1_r in T.
exact T.
Qed.

Lemma norm_bound_nonneg r M f : norm_at_most r M f -> 0 <= M.
Proof. intros (a & Ha & _). exact (Ha 0%nat). Qed.

Lemma norm_ext r M f g : (forall x, Rabs x < r -> f x = g x) -> norm_at_most r M f -> norm_at_most r M g.
Proof. intros E (a & Ha & Hf). exists a. split; auto. intros x Hx. rewrite <- E; auto. Qed.

Lemma norm_weaken r M M' f : M <= M' -> norm_at_most r M f -> norm_at_most r M' f.
Proof. intros H (a & Ha & Hf). exists a. split; auto. intros N. eapply Rle_trans; [apply Ha|exact H]. Qed.

Lemma norm_smaller r r' M f : 0 < r' <= r -> norm_at_most r M f -> norm_at_most r' M f.
Proof.
intros Hr (a & Ha & Hf). exists a. split.
- intros N. eapply Rle_trans; [|apply (Ha N)]. apply sum_first_le. intros n. apply Rmult_le_compat_l. apply Rabs_pos.
  apply pow_incr. lra.
- intros x Hx. apply Hf. lra.
Qed.

Lemma norm_const r c : norm_at_most r (Rabs c) (fun _ => c).
Proof.
exists (fun n => match n with O => c | _ => 0 end). split.
- intros N. assert (H : sum_first (fun n => Rabs (match n with O => c | _ => 0 end) * r ^ n) N <= Rabs c /\ 
    forall N', N = S N' -> sum_first (fun n => Rabs (match n with O => c | _ => 0 end) * r ^ n) N = Rabs c); [|apply H].
  induction N as [|[|N] [I1 I2]].
  + split. simpl. apply Rabs_pos. discriminate.
  + simpl. split. lra. intros. ring.
  + specialize (I2 N eq_refl). change (sum_first ?u (S (S N))) with (sum_first u (S N) + u (S N)). rewrite I2, Rabs_R0.
    split. lra. intros; ring.
- intros x _. apply is_pseries_sum_first. apply is_lim_seq_incr_1.
  apply (is_lim_seq_ext (fun _ => c)); [|apply is_lim_seq_const].
  induction n as [|n IH]. simpl; ring.
  change (c = sum_first (fun n => match n with O => c | _ => 0 end * x ^ n) (S n) + 0 * x ^ S n). rewrite <- IH. ring.
Qed.

Lemma norm_plus r M N f g : norm_at_most r M f -> norm_at_most r N g -> 0 < r -> norm_at_most r (M + N) (fun x =>
  f x + g x).
Proof.
intros (a & Ha & Hf) (b & Hb & Hg) Hr. exists (PS_plus a b). split.
- intros K. specialize (Ha K). specialize (Hb K).
  apply Rle_trans with (sum_first (fun n => Rabs (a n) * r ^ n + Rabs (b n) * r ^ n) K).
  + apply sum_first_le. intros n. unfold PS_plus. rewrite <- Rmult_plus_distr_r. apply Rmult_le_compat_r.
    apply pow_le; lra. apply Rabs_triang.
  + rewrite sum_first_plus. lra.
- intros x Hx. apply (is_pseries_plus a b); auto.
Qed.

Lemma norm_scal r M c f : norm_at_most r M f -> norm_at_most r (Rabs c * M) (fun x => c * f x).
Proof.
intros (a & Ha & Hf). exists (PS_scal c a). split.
- intros K. rewrite (sum_first_ext _ (fun n => Rabs c * (Rabs (a n) * r ^ n))).
  + rewrite sum_first_scal. apply Rmult_le_compat_l. apply Rabs_pos. apply Ha.
  + intros n. unfold PS_scal, scal; simpl; unfold mult; simpl. rewrite Rabs_mult. ring.
- intros x Hx. apply (is_pseries_scal c a x (f x)). apply Rmult_comm. auto.
Qed.

Lemma norm_id r : 0 < r -> norm_at_most r r (fun x => x).
Proof.
intros Hr. destruct (norm_const r 1) as (a & Ha & Hf). rewrite Rabs_R1 in Ha. exists (PS_incr_1 a). split.
- intros [|N]. simpl. lra.
  assert (H : sum_first (fun n => Rabs (PS_incr_1 a n) * r ^ n) (S N) = r * sum_first (fun n => Rabs (a n) * r ^ n) N).
  { induction N as [|N IH].
    - simpl. unfold zero; simpl. rewrite Rabs_R0. ring.
    - change (sum_first ?u (S (S N))) with (sum_first u (S N) + u (S N)) at 1. rewrite IH. simpl. ring. }
  rewrite H. rewrite <- (Rmult_1_r r) at 2. apply Rmult_le_compat_l; [lra|apply Ha].
- intros x Hx. assert (E := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) a x 1 (Hf x Hx)).
  change (scal x 1) with (x * 1) in E. rewrite Rmult_1_r in E. exact E.
Qed.

(** Products: Cauchy's product, summed over the triangle. *)
Lemma sum_first_sum_f u n : sum_f_R0 u n = sum_first u (S n).
Proof. induction n as [|n IH]; simpl. ring. rewrite IH. reflexivity. Qed.

Lemma triangle u v : (forall n, 0 <= u n) -> (forall n, 0 <= v n) -> forall N,
  sum_first (fun n => sum_f_R0 (fun k => u k * v (n - k)%nat) n) N <= sum_first u N * sum_first v N.
Proof.
intros Hu Hv.
assert (E : forall N, sum_first (fun n => sum_f_R0 (fun k => u k * v (n - k)%nat) n) N = sum_first (fun k =>
  u k * sum_first v (N - k)) N).
{ induction N as [|N IH]; [reflexivity|]. cbn [sum_first]. rewrite IH, sum_first_sum_f. cbn [sum_first].
  replace (S N - N)%nat with 1%nat by lia. replace (N - N)%nat with 0%nat by lia.
  rewrite <- Rplus_assoc, <- sum_first_plus. simpl (sum_first v 1). rewrite Rplus_0_l. f_equal.
  assert (X : forall K, (K <= N)%nat -> sum_first (fun n => u n * sum_first v (N - n) + u n * v (N - n)%nat) K
    = sum_first (fun k => u k * sum_first v (S N - k)) K).
  { induction K as [|K IHK]; intros HK; [reflexivity|]. cbn [sum_first]. rewrite IHK by lia. f_equal.
    replace (S N - K)%nat with (S (N - K)) by lia. simpl. ring. }
  apply X. lia. }
intros N. rewrite E.
assert (X : forall K, (K <= N)%nat -> sum_first (fun k => u k * sum_first v (N - k)) K
  <= sum_first u K * sum_first v N).
{ induction K as [|K IHK]; intros HK; simpl. lra. specialize (IHK ltac:(lia)). rewrite Rmult_plus_distr_r.
  apply Rplus_le_compat; auto.
  apply Rmult_le_compat_l; auto. replace N with (N - K + K)%nat at 2 by lia. apply sum_first_grow, Hv. }
apply X. lia.
Qed.

Lemma norm_mult r M N f g : 0 < r -> norm_at_most r M f -> norm_at_most r N g -> norm_at_most r (M * N) (fun x =>
  f x * g x).
Proof.
intros Hr (a & Ha & Hf) (b & Hb & Hg). exists (PS_mult a b). split.
- intros K.
  apply Rle_trans with
    (sum_first (fun n => sum_f_R0 (fun k => (Rabs (a k) * r ^ k) * (Rabs (b (n - k)%nat) * r ^ (n - k))) n) K).
  + apply sum_first_le. intros n. unfold PS_mult. rewrite Rmult_comm.
    apply Rle_trans with (r ^ n * sum_f_R0 (fun k => Rabs (a k * b (n - k)%nat)) n).
    { apply Rmult_le_compat_l; [apply pow_le; lra|apply Rsum_abs]. }
    rewrite scal_sum.
    apply sum_Rle. intros k Hk. rewrite Rabs_mult. replace (r ^ n) with (r ^ k * r ^ (n - k)).
    right; ring. rewrite <- pow_add. f_equal. lia.
  + assert (Pa : forall n, 0 <= Rabs (a n) * r ^ n) by (intros; apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra]).
    assert (Pb : forall n, 0 <= Rabs (b n) * r ^ n) by (intros; apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra]).
    eapply Rle_trans; [apply (triangle (fun n => Rabs (a n) * r ^ n) (fun n => Rabs (b n) * r ^ n)); auto|].
    apply Rmult_le_compat; auto; apply sum_first_nonneg; auto.
- intros x Hx. apply is_pseries_mult; auto; eapply radius_at_least; eauto.
Qed.

Lemma norm_pow r M f k : 0 < r -> norm_at_most r M f -> norm_at_most r (M ^ k) (fun x => f x ^ k).
Proof.
intros Hr Hf. induction k as [|k IH]; simpl.
- apply (norm_weaken r (Rabs 1)). rewrite Rabs_R1; lra. apply norm_const.
- apply norm_mult; auto.
Qed.

(** A smaller variable, and a function that vanishes at 0. *)
Lemma norm_contract r M f c : Rabs c <= 1 -> 0 < r -> norm_at_most r M f -> norm_at_most r M (fun x => f (c * x)).
Proof.
intros Hc Hr (a & Ha & Hf). exists (fun n => a n * c ^ n). split.
- intros N. eapply Rle_trans; [|apply (Ha N)]. apply sum_first_le. intros n. apply Rmult_le_compat_r. apply pow_le; lra.
  rewrite Rabs_mult, <- RPow_abs. rewrite <- (Rmult_1_r (Rabs (a n))) at 2. apply Rmult_le_compat_l. apply Rabs_pos.
  rewrite <- (pow1 n). apply pow_incr. split; [apply Rabs_pos|auto].
- intros x Hx. apply is_pseries_sum_first. apply (is_lim_seq_ext (fun N => sum_first (fun n => a n * (c * x) ^ n) N)).
  + intros N. apply sum_first_ext. intros n. rewrite Rpow_mult_distr. ring.
  + apply is_pseries_sum_first, Hf. rewrite Rabs_mult. assert (P := Rabs_pos x). nra.
Qed.

Lemma norm_vanishing r r' M f : 0 < r' <= r -> f 0 = 0 -> norm_at_most r M f -> norm_at_most r' (M * (r' / r)) f.
Proof.
intros Hr H0 (a & Ha & Hf). exists a.
assert (a0 : a 0%nat = 0).
{ assert (E := Hf 0 ltac:(rewrite Rabs_R0; lra)). apply is_pseries_unique in E. rewrite PSeries_0, H0 in E. exact E. }
assert (Q : 0 <= r' / r <= 1).
{ split. apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]. apply Rmult_le_reg_r with r; [lra|].
  replace (r' / r * r) with r' by (field; lra). lra. }
split.
- intros N. rewrite Rmult_comm. eapply Rle_trans; [|apply Rmult_le_compat_l; [apply Q|apply (Ha N)]].
  rewrite <- sum_first_scal.
  apply sum_first_le. intros [|n]. rewrite a0, Rabs_R0. simpl. lra.
  replace (r' ^ S n) with (r' / r * (r' / r) ^ n * r ^ S n).
  2: { rewrite pow_quotient. simpl. field. split; [apply pow_nonzero|]; lra. }
  assert (P : (r' / r) ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  assert (P0 : 0 <= Rabs (a (S n)) * r ^ S n) by (apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra]).
  assert (P1 : 0 <= (r' / r) ^ n) by (apply pow_le; lra).
  replace (Rabs (a (S n)) * (r' / r * (r' / r) ^ n * r ^ S n)) with (r' / r * (Rabs (a (S n)) * r ^ S n) * (r' / r) ^ n)
    by ring.
  rewrite <- (Rmult_1_r (r' / r * (Rabs (a (S n)) * r ^ S n))) at 2. apply Rmult_le_compat_l; auto.
  apply Rmult_le_pos; lra.
- intros x Hx. apply Hf. lra.
Qed.
