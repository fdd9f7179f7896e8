(** * The saddle: the inverse of s = u sqrt(1 + u/3) as a power series

    u = s/sqrt(1 + u/3) is a fixed point. With radius = eta sqrt(1 - eta/3) the map takes the power series u(s) of norm
    at most eta on |s| < radius into themselves, for the norm of 1/sqrt(1 + u/3) is at most 1/sqrt(1 - eta/3); and for
    each s it contracts [-eta, eta] by 1/4. So its iterates tend to the inverse function, which by [norm_limit] is a
    power series of norm at most eta. Then (1 + u)^c du/ds is one, too, with an explicit norm: no complex numbers. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus PowerSeriesNorm NormLimit BinomialSeries.
Open Scope R_scope.

Definition saddle (u : R) : R := u * sqrt (1 + u / 3).

Definition saddle_slope (u : R) : R := (1 + u / 2) / sqrt (1 + u / 3).

Lemma root_pos u : -3 < u -> 0 < sqrt (1 + u / 3).
Proof. intros Hu. apply sqrt_lt_R0. lra. Qed.

Lemma root_square u : -3 < u -> sqrt (1 + u / 3) * sqrt (1 + u / 3) = 1 + u / 3.
Proof. intros Hu. apply sqrt_sqrt. lra. Qed.

Lemma saddle_square u : -3 < u -> saddle u ^ 2 = u ^ 2 + u ^ 3 / 3.
Proof.
intros Hu. unfold saddle. rewrite Rpow_mult_distr.
replace (sqrt (1 + u / 3) ^ 2) with (sqrt (1 + u / 3) * sqrt (1 + u / 3)) by ring. rewrite root_square by exact Hu.
field.
Qed.

Lemma saddle_derive u : -3 < u -> is_derive saddle u (saddle_slope u).
Proof.
intros Hu. unfold saddle, saddle_slope. assert (P := root_pos u Hu). assert (S := root_square u Hu).
auto_derive. lra. replace (1 + u * / 3) with (1 + u / 3) by (unfold Rdiv; ring).
apply Rmult_eq_reg_r with (sqrt (1 + u / 3)); [|lra].
replace ((1 * sqrt (1 + u / 3) + u * (1 * / 3 * / (2 * sqrt (1 + u / 3)))) * sqrt (1 + u / 3))
  with (sqrt (1 + u / 3) * sqrt (1 + u / 3) + u / 6) by (field; lra).
rewrite S. field. lra.
Qed.

Lemma slope_pos u : -2 < u -> 0 < saddle_slope u.
Proof. intros Hu. apply Rdiv_lt_0_compat. lra. apply root_pos. lra. Qed.

Lemma saddle_increasing u v : -2 < u -> u < v -> saddle u < saddle v.
Proof.
intros Hu Huv. destruct (mvt_open saddle saddle_slope u v Huv) as (d & Hd & E).
- intros t Ht. apply saddle_derive. lra.
- assert (P := slope_pos d ltac:(lra)). assert (0 < saddle_slope d * (v - u)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma slope_at_least_1 u : 0 <= u -> 1 <= saddle_slope u.
Proof.
intros Hu. assert (P := root_pos u ltac:(lra)). assert (S := root_square u ltac:(lra)).
apply Rmult_le_reg_r with (sqrt (1 + u / 3)); auto. unfold saddle_slope.
replace ((1 + u / 2) / sqrt (1 + u / 3) * sqrt (1 + u / 3)) with (1 + u / 2) by (field; lra). nra.
Qed.

Lemma saddle_above u : 0 <= u -> u <= saddle u.
Proof.
intros Hu. assert (P := root_pos u ltac:(lra)). assert (S := root_square u ltac:(lra)). unfold saddle.
assert (1 <= sqrt (1 + u / 3)) by nra. nra.
Qed.

Section Inverse.
Variable eta : R.
Hypothesis Heta : 0 < eta < 1.

Let root := sqrt (1 - eta / 3).
Definition saddle_radius : R := eta * sqrt (1 - eta / 3).

Lemma least_root : 0 < root /\ root * root = 1 - eta / 3.
Proof. split. apply sqrt_lt_R0; lra. apply sqrt_sqrt; lra. Qed.

Lemma radius_pos : 0 < saddle_radius.
Proof. apply Rmult_lt_0_compat; [lra|apply least_root]. Qed.

Lemma saddle_left : saddle (- eta) = - saddle_radius.
Proof. unfold saddle, saddle_radius. replace (1 + - eta / 3) with (1 - eta / 3) by field. ring. Qed.

Lemma saddle_right : saddle_radius < saddle eta.
Proof.
unfold saddle, saddle_radius. apply Rmult_lt_compat_l; [lra|]. apply sqrt_lt_1; lra.
Qed.

Lemma saddle_continuous u : -3 < u -> continuity_pt saddle u.
Proof.
intros Hu. apply continuity_pt_filterlim, (ex_derive_continuous saddle u). eexists. apply saddle_derive, Hu.
Qed.

(** The inverse exists on the whole interval, in real numbers. *)
Lemma inverse_exists s : - saddle_radius <= s <= saddle_radius -> exists u, - eta <= u <= eta /\ saddle u = s.
Proof.
intros Hs. assert (R := saddle_right). assert (L := saddle_left).
destruct (Ranalysis5.f_interv_is_interv saddle (- eta) eta s) as (u & Hu & E); try lra.
- intros u Hu. apply saddle_continuous. lra.
- exists u. auto.
Qed.

Lemma inverse_unique u v : - eta <= u <= eta -> - eta <= v <= eta -> saddle u = saddle v -> u = v.
Proof.
intros Hu Hv E. destruct (Rtotal_order u v) as [H|[H|H]]; auto.
- assert (saddle u < saddle v) by (apply saddle_increasing; lra). lra.
- assert (saddle v < saddle u) by (apply saddle_increasing; lra). lra.
Qed.

Definition fixed_map (s u : R) : R := s * / sqrt (1 + u / 3).

Lemma fixed_point u : - eta <= u <= eta -> fixed_map (saddle u) u = u.
Proof. intros Hu. unfold fixed_map, saddle. field. apply Rgt_not_eq, root_pos. lra. Qed.

Lemma root_above u : - eta <= u -> root <= sqrt (1 + u / 3).
Proof. intros Hu. apply sqrt_le_1_alt. lra. Qed.

Lemma contraction s u v : Rabs s <= saddle_radius -> Rabs u <= eta -> Rabs v <= eta ->
  Rabs (fixed_map s u - fixed_map s v) <= / 4 * Rabs (u - v).
Proof.
intros Hs Hu Hv. apply Rabs_le_between in Hu. apply Rabs_le_between in Hv. destruct least_root as [K KK].
assert (Ku := root_above u (proj1 Hu)). assert (Kv := root_above v (proj1 Hv)).
assert (Su := root_square u ltac:(lra)). assert (Sv := root_square v ltac:(lra)).
unfold fixed_map. set (p := sqrt (1 + u / 3)) in *. set (q := sqrt (1 + v / 3)) in *.
assert (P1 : root * root <= p * q) by (apply Rmult_le_compat; lra).
assert (P2 : 0 < p * q * (p + q)) by (repeat apply Rmult_lt_0_compat; lra).
assert (E : s * / p - s * / q = s * (v - u) / (3 * (p * q * (p + q)))).
{ replace (v - u) with (3 * (q * q - p * p)) by (rewrite Su, Sv; field). field. repeat split; lra. }
assert (B : 2 * root * (root * root) <= p * q * (p + q)).
{ rewrite (Rmult_comm (p * q)). apply Rmult_le_compat; try lra. }
rewrite E. unfold Rdiv. rewrite !Rabs_mult, (Rabs_minus_sym v u), Rabs_inv, (Rabs_pos_eq (3 * _)) by lra.
rewrite (Rmult_comm (Rabs s)), Rmult_assoc, (Rmult_comm (/ 4)).
apply Rmult_le_compat_l; [apply Rabs_pos|].
apply Rmult_le_reg_r with (3 * (p * q * (p + q))); [lra|].
rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
unfold saddle_radius in Hs. fold root in Hs. nra.
Qed.

Lemma map_norm v : norm_at_most saddle_radius eta v -> norm_at_most saddle_radius eta (fun s => fixed_map s (v s)).
Proof.
intros Hv. assert (P := radius_pos). destruct least_root as [K KK].
assert (N : norm_at_most saddle_radius (eta / 3) (fun s => - / 3 * v s)).
{ apply (norm_weaken _ (Rabs (- / 3) * eta)). rewrite Rabs_Ropp, Rabs_pos_eq; lra. apply norm_scal, Hv. }
apply (norm_ext saddle_radius _ (fun s => s * Rpower (1 - - / 3 * v s) (- / 2))).
{ intros s Hs. assert (V := norm_value _ _ _ s P Hv Hs). apply Rabs_le_between in V. unfold fixed_map. f_equal.
  rewrite Rpower_Ropp, Rpower_sqrt by lra. do 2 f_equal. field. }
apply (norm_weaken _ (saddle_radius * Rpower (1 - eta / 3) (- / 2))).
{ right. rewrite Rpower_Ropp, Rpower_sqrt by lra. unfold saddle_radius. fold root. field. lra. }
apply (norm_mult _ _ _ (fun s => s)); auto. apply norm_id, P.
apply norm_negative_power; auto; lra.
Qed.

Theorem inverse_series : exists U, norm_at_most saddle_radius eta U /\
  forall u, - eta <= u <= eta -> Rabs (saddle u) < saddle_radius -> U (saddle u) = u.
Proof.
assert (P := radius_pos).
set (x := fun k : nat => Nat.iter k (fun x s => fixed_map s (x s)) (fun _ => 0)).
assert (Nx : forall k, norm_at_most saddle_radius eta (x k)).
{ induction k as [|k IH]; [|exact (map_norm (x k) IH)].
  apply (norm_weaken _ (Rabs 0)). rewrite Rabs_R0; lra. apply norm_const. }
assert (L : forall u, - eta <= u <= eta -> Rabs (saddle u) < saddle_radius -> is_lim_seq (fun k => x k (saddle u)) u).
{ intros u Hu Hs. set (s := saddle u) in *.
  assert (B : forall k, Rabs (x k s - u) <= eta * (/ 4) ^ k).
  { induction k as [|k IH].
    - simpl. rewrite Rmult_1_r. unfold Rminus. rewrite Rplus_0_l, Rabs_Ropp. apply Rabs_le. lra.
    - change (x (S k) s) with (fixed_map s (x k s)). rewrite <- (fixed_point u Hu) at 1.
      assert (V := norm_value _ _ _ s P (Nx k) Hs).
      eapply Rle_trans; [apply contraction; [exact (Rlt_le _ _ Hs)|exact V|apply Rabs_le; lra]|]. simpl. lra. }
  assert (G : is_lim_seq (fun k => eta * (/ 4) ^ k) 0).
  { replace (Finite 0) with (Rbar_mult eta 0) by (simpl; f_equal; ring).
    apply (is_lim_seq_scal_l _ eta 0), is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  apply (is_lim_seq_le_le (fun k => u - eta * (/ 4) ^ k) _ (fun k => u + eta * (/ 4) ^ k)).
  - intros k. specialize (B k). apply Rabs_le_between in B. lra.
  - replace (Finite u) with (Finite (u - 0)) by (f_equal; ring). apply is_lim_seq_minus'; auto. apply is_lim_seq_const.
  - replace (Finite u) with (Finite (u + 0)) by (f_equal; ring). apply is_lim_seq_plus'; auto. apply is_lim_seq_const. }
set (U := fun s => real (Lim_seq (fun k => x k s))).
assert (HU : forall u, - eta <= u <= eta -> Rabs (saddle u) < saddle_radius -> U (saddle u) = u).
{ intros u Hu Hs. unfold U. rewrite (is_lim_seq_unique _ _ (L u Hu Hs)). reflexivity. }
exists U. split; auto.
apply (norm_limit (Fl := eventually) x U (fun _ => eta) _ eta P).
- apply filter_forall, Nx.
- apply tends_const.
- intros s Hs. apply Rabs_lt_between in Hs. destruct (inverse_exists s ltac:(lra)) as (u & Hu & E). subst s.
  rewrite HU by (try apply Rabs_lt_between; auto). apply L; auto. apply Rabs_lt_between, Hs.
Qed.

(** (1 + u)^c du/ds. *)
Definition saddle_bound (c : R) (m : nat) : R :=
  (1 + eta) ^ m * Rpower (1 - eta) (c - INR m) * (2 - sqrt (1 - eta / 3)) / (1 - eta / 2).

Theorem saddle_series (c : R) (m : nat) : c <= INR m -> exists a : nat -> R,
  (forall N, sum_first (fun n => Rabs (a n) * saddle_radius ^ n) N <= saddle_bound c m) /\
  forall u, - eta <= u <= eta -> Rabs (saddle u) < saddle_radius ->
    is_pseries a (saddle u) (Rpower (1 + u) c / saddle_slope u).
Proof.
intros Hc. assert (P := radius_pos). destruct inverse_series as (U & NU & HU).
assert (scaled : forall k, norm_at_most saddle_radius (Rabs k * eta) (fun s => k * U s)) by (intros; apply norm_scal,
  NU).
assert (N1 : norm_at_most saddle_radius ((1 + eta) ^ m) (fun s => (1 + U s) ^ m)).
{ apply norm_pow; auto. apply norm_plus; auto. apply (norm_weaken _ (Rabs 1)). rewrite Rabs_R1; lra. apply norm_const. }
assert (N2 : norm_at_most saddle_radius (Rpower (1 - eta) (- (INR m - c)))
  (fun s => Rpower (1 - -1 * U s) (- (INR m - c)))).
{ apply norm_negative_power; auto; try lra. apply (norm_weaken _ (Rabs (-1) * eta)); auto.
  rewrite Rabs_left; lra. }
assert (N3 : norm_at_most saddle_radius (2 - sqrt (1 - eta / 3)) (fun s => sqrt (1 - - / 3 * U s))).
{ apply norm_root; auto; try lra. apply (norm_weaken _ (Rabs (- / 3) * eta)); auto. rewrite Rabs_left; lra. }
assert (N4 : norm_at_most saddle_radius (/ (1 - eta / 2)) (fun s => / (1 - - / 2 * U s))).
{ apply norm_geometric; auto; try lra. apply (norm_weaken _ (Rabs (- / 2) * eta)); auto. rewrite Rabs_left; lra. }
destruct (norm_mult _ _ _ _ _ P (norm_mult _ _ _ _ _ P (norm_mult _ _ _ _ _ P N1 N2) N3) N4) as (a & Ha & Hf).
exists a. split.
- intros N. eapply Rle_trans; [apply Ha|]. right. unfold saddle_bound. replace (- (INR m - c)) with (c - INR m) by ring.
  reflexivity.
- intros u Hu Hs. specialize (Hf _ Hs). cbv beta in Hf. rewrite HU in Hf by auto.
  replace (Rpower (1 + u) c / saddle_slope u) with ((1 + u) ^ m * Rpower (1 - -1 * u) (- (INR m - c))
    * sqrt (1 - - / 3 * u) * / (1 - - / 2 * u)); auto.
  replace (1 - -1 * u) with (1 + u) by ring. replace (1 - - / 3 * u) with (1 + u / 3) by field.
  replace (1 - - / 2 * u) with (1 + u / 2) by field.
  replace ((1 + u) ^ m * Rpower (1 + u) (- (INR m - c))) with (Rpower (1 + u) c).
  + unfold saddle_slope. assert (R := root_pos u ltac:(lra)). field. split; lra.
  + rewrite <- (Rpower_pow m) by lra. rewrite <- Rpower_plus. f_equal. ring.
Qed.
End Inverse.
