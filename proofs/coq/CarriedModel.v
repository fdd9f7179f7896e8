(** * From one point to the next

    Sections 2 and 3 of proofs/check.md. The d-th derivative of a solution has the coefficients C(k, d) c_k at t0, and
    they satisfy the recurrence with b - d; so the tail lemma bounds what is left out of the sums for F, F', F''/2 at
    once. The errors at t0 are carried by linearity: a solution is determined by its values at t0. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementModels Calculus Gronwall RecurrenceTail SolutionSeries DerivativeTail
  BoxModel.
Open Scope R_scope.

(** ** Solutions and their coefficients *)
Lemma solution_solves b f : solution b f -> solves b f (Derive f) (Derive_n f 2).
Proof.
intros (Hex & Hode).
assert (D : forall n t, (n < 3)%nat -> is_derive (Derive_n f n) t (Derive_n f (S n) t)).
{ intros n t Hn. apply (Derive_correct (Derive_n f n)). exact (Hex (S n) t Hn). }
refine (conj (fun t => D 0%nat t ltac:(lia)) (conj (fun t => D 1%nat t ltac:(lia)) _)).
intros t. replace (t * Derive f t - b * f t) with (Derive_n f 3 t) by (generalize (Hode t); lra). apply D; lia.
Qed.

Lemma solves_solution b f f1 f2 : solves b f f1 f2 -> solution b f.
Proof.
intros (D0 & D1 & D2).
assert (E1 : forall t, Derive f t = f1 t) by (intros t; apply is_derive_unique, D0).
assert (E2 : forall t, Derive_n f 2 t = f2 t).
{ intros t; simpl. rewrite (Derive_ext _ f1) by (intros; apply E1). apply is_derive_unique, D1. }
assert (E3 : forall t, Derive_n f 3 t = t * f1 t - b * f t).
{ intros t. change (Derive (Derive_n f 2) t = t * f1 t - b * f t).
  rewrite (Derive_ext _ f2) by (intros; apply E2). apply is_derive_unique, D2. }
split.
- intros [|[|[|[|k]]]] t Hk; [exact I | | | |lia]; unfold ex_derive_n.
  + exists (f1 t). apply (is_derive_ext f); auto.
  + exists (f2 t). apply (is_derive_ext f1); auto. intros s; symmetry; apply E1.
  + exists (t * f1 t - b * f t). apply (is_derive_ext f2); auto.
- intros t. rewrite E3, E1. ring.
Qed.

Definition coefficient_at (f : R -> R) (t0 : R) (k : nat) : R := Derive_n f k t0 / INR (fact k).

Section Solution.
Variables (b t0 : R) (f : R -> R).
Hypothesis H : solution b f.

Let c := from_values b t0 (f t0) (Derive f t0) (Derive_n f 2 t0 / 2).

Lemma coefficient_at_values k : c k = coefficient_at f t0 k.
Proof.
unfold coefficient_at.
rewrite (Derive_n_coefficient k b t0 c f (Derive f) (Derive_n f 2) (solution_solves b f H)
  (from_values_recurrence _ _ _ _ _)).
- field. apply INR_fact_neq_0.
- reflexivity.
- reflexivity.
- unfold c, from_values. simpl. field.
Qed.

Lemma coefficient_at_recurrence : recurrence b t0 (coefficient_at f t0).
Proof. intros k. rewrite <- !coefficient_at_values. apply from_values_recurrence. Qed.

Lemma solution_is_series t : f t = PSeries (coefficient_at f t0) (t + - t0).
Proof.
assert (P := solution_series b t0 c (from_values_recurrence _ _ _ _ _) f (Derive f) (Derive_n f 2)
  (solution_solves b f H)).
rewrite (PSeries_ext (coefficient_at f t0) c) by (intros k; symmetry; apply coefficient_at_values).
symmetry. apply is_pseries_unique. apply P; try reflexivity. unfold c, from_values. simpl. field.
Qed.

(** s^d F^(d)(t0 + s u)/d! is the sum of C(k, d) a_k u^(k-d), a_k = c_k s^k *)
Lemma derivative_at s u d : is_lim_seq
  (sum_first (fun j => Binomial.C (d + j) d * (coefficient_at f t0 (d + j) * s ^ (d + j)) * u ^ j))
  (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d)).
Proof.
assert (Hr := coefficients_radius b t0 (coefficient_at f t0) coefficient_at_recurrence).
rewrite (Derive_n_ext f _ d _ solution_is_series).
rewrite (Derive_n_comp_trans (PSeries (coefficient_at f t0)) d (t0 + s * u) (- t0)).
replace (t0 + s * u + - t0) with (s * u) by ring. rewrite Derive_n_PSeries by (rewrite Hr; exact I).
assert (P := PSeries_correct _ (s * u) (CV_radius_inside (PS_derive_n d (coefficient_at f t0)) (s * u)
  ltac:(rewrite CV_radius_derive_n, Hr; exact I))).
set (y := PSeries _ (s * u)) in *.
assert (L : is_lim_seq (sum_n (fun k => scal (pow_n (s * u) k) (PS_derive_n d (coefficient_at f t0) k))) y) by exact P.
assert (L' : is_lim_seq (fun n => s ^ d / INR (fact d) * sum_n (fun k =>
  scal (pow_n (s * u) k) (PS_derive_n d (coefficient_at f t0) k)) n)
  (s ^ d / INR (fact d) * y)) by exact (is_lim_seq_scal_l _ (s ^ d / INR (fact d)) y L).
replace (s ^ d * y / INR (fact d)) with (s ^ d / INR (fact d) * y) by (unfold Rdiv; ring).
apply is_lim_seq_incr_1. eapply is_lim_seq_ext; [|exact L']. intros n. cbv beta. rewrite sum_n_Reals, sum_f_first.
rewrite <- sum_first_factor. apply sum_ext. intros k _. cbv beta. rewrite (pow_n_pow (s * u) k).
unfold PS_derive_n, Binomial.C.
replace (d + k - d)%nat with k by lia. rewrite (Nat.add_comm k d), pow_add, Rpow_mult_distr.
unfold scal; simpl; unfold mult; simpl.
field. split; apply INR_fact_neq_0.
Qed.
End Solution.

(** ** Three sums at once *)
Lemma recurrence_derivative d : forall b t0 c, recurrence b t0 c -> recurrence (b - INR d) t0 (fun j =>
  Binomial.C (d + j) d * c (d + j)%nat).
Proof.
intros b t0 c H k. assert (R := H (d + k)%nat). replace (d + (k + 3))%nat with (d + k + 3)%nat by lia.
replace (d + (k + 1))%nat with (d + k + 1)%nat by lia.
assert (Hk := pos_INR k). assert (Hd := pos_INR d).
rewrite plus_INR in R. set (x := INR k) in *. set (y := INR d) in *.
assert (F1 := INR_fact_neq_0 d). assert (F2 := INR_fact_neq_0 k). assert (F3 := INR_fact_neq_0 (d + k)).
assert (B0 : Binomial.C (d + k) d = INR (fact (d + k)) / (INR (fact d) * INR (fact k))).
{ unfold Binomial.C. replace (d + k - d)%nat with k by lia. reflexivity. }
assert (B1 : (x + 1) * Binomial.C (d + k + 1) d = (y + x + 1) * Binomial.C (d + k) d).
{ rewrite B0. unfold Binomial.C. replace (d + k + 1 - d)%nat with (S k) by lia.
  replace (d + k + 1)%nat with (S (d + k)) by lia.
  rewrite !fact_simpl, !mult_INR, !S_INR, plus_INR. fold x y. field. repeat split; auto; lra. }
assert (B3 : (x + 1) * (x + 2) * (x + 3) * Binomial.C (d + k + 3) d = (y + x + 1) * (y + x + 2) * (y + x + 3)
  * Binomial.C (d + k) d).
{ rewrite B0. unfold Binomial.C. replace (d + k + 3 - d)%nat with (S (S (S k))) by lia.
  replace (d + k + 3)%nat with (S (S (S (d + k)))) by lia.
  rewrite !fact_simpl, !mult_INR, !S_INR, plus_INR. fold x y. field. repeat split; auto; lra. }
replace ((x + 1) * (x + 2) * (x + 3) * (Binomial.C (d + k + 3) d * c (d + k + 3)%nat))
  with ((x + 1) * (x + 2) * (x + 3) * Binomial.C (d + k + 3) d * c (d + k + 3)%nat) by ring.
rewrite B3. replace (t0 * (x + 1) * (Binomial.C (d + k + 1) d * c (d + k + 1)%nat))
  with (t0 * ((x + 1) * Binomial.C (d + k + 1) d) * c (d + k + 1)%nat) by ring.
rewrite B1. replace ((y + x + 1) * (y + x + 2) * (y + x + 3) * Binomial.C (d + k) d * c (d + k + 3)%nat)
  with (Binomial.C (d + k) d * ((y + x + 1) * (y + x + 2) * (y + x + 3) * c (d + k + 3)%nat)) by ring.
rewrite R. ring.
Qed.

Lemma binomial_pos k d : 0 < Binomial.C k d.
Proof. unfold Binomial.C. apply Rdiv_lt_0_compat. apply INR_fact_lt_0. apply Rmult_lt_0_compat; apply INR_fact_lt_0.
Qed.

Lemma binomial_increases d k n : (d <= k)%nat -> (k <= n)%nat -> Binomial.C k d <= Binomial.C n d.
Proof.
intros Hd. induction 1 as [|n Hn IH]; [apply Rle_refl|]. eapply Rle_trans; [exact IH|].
unfold Binomial.C. replace (S n - d)%nat with (S (n - d)) by lia. rewrite !fact_simpl, !mult_INR, !S_INR.
assert (F1 := INR_fact_lt_0 n). assert (F2 := INR_fact_lt_0 d). assert (F3 := INR_fact_lt_0 (n - d)).
assert (L : INR (n - d) <= INR n) by (apply le_INR; lia). assert (P := pos_INR (n - d)).
replace ((INR n + 1) * INR (fact n) / (INR (fact d) * ((INR (n - d) + 1) * INR (fact (n - d)))))
  with (INR (fact n) / (INR (fact d) * INR (fact (n - d))) * ((INR n + 1) / (INR (n - d) + 1)))
    by (field; repeat split; lra).
rewrite <- (Rmult_1_r (INR (fact n) / (INR (fact d) * INR (fact (n - d))))) at 1. apply Rmult_le_compat_l.
- apply Rlt_le, Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto.
- apply Rmult_le_reg_r with (INR (n - d) + 1). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Theorem three_tails b t0 s B (c : nat -> R) (n d N : nat) : 0 < s -> 1 <= B -> Rabs b + 2 <= B -> (d <= 2)%nat ->
  (5 <= n)%nat ->
  recurrence b t0 c -> ratio t0 s B (n - 5) <= 1 / 2 ->
  let a k := Rabs (c k) * s ^ k in
  sum_first (fun i => Binomial.C (n + i) d * a (n + i)%nat) N
    <= Binomial.C (n - 1) d * (3 * Rmax (a (n - 3)%nat) (Rmax (a (n - 2)%nat) (a (n - 1)%nat))).
Proof.
intros Hs HB Hb Hd Hn Hc Hq a.
set (I := (n - 3 - d)%nat). set (c' := fun j => Binomial.C (d + j) d * c (d + j)%nat).
assert (Hd' : 0 <= INR d <= 2). { split. apply pos_INR. apply (le_INR d 2), Hd. }
assert (Hb' : Rabs (b - INR d) <= B).
{ eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, (Rabs_pos_eq (INR d)) by lra. lra. }
assert (R := recurrence_derivative d b t0 c Hc). fold c' in R.
assert (Q : ratio t0 s B I <= 1 / 2).
{ eapply Rle_trans; [|exact Hq]. apply ratio_decreases; auto. unfold I. lia. }
assert (Q0 : 0 <= ratio t0 s B I) by (apply ratio_pos; auto).
assert (T := RecurrenceTail.recurrence_tail (b - INR d) t0 s B c' I Hs HB Hb' R ltac:(lra) N).
assert (Sz : forall j, s ^ d * size s c' j = Binomial.C (d + j) d * a (d + j)%nat).
{ intros j. unfold size, c', a. rewrite Rabs_mult, (Rabs_pos_eq (Binomial.C _ _)) by (apply Rlt_le, binomial_pos).
  rewrite pow_add. ring. }
assert (Sp : 0 < s ^ d) by (apply pow_lt, Hs).
assert (T' := Rmult_le_compat_l (s ^ d) _ _ (Rlt_le _ _ Sp) T). rewrite <- sum_first_factor in T'.
rewrite (sum_ext _ (fun i => Binomial.C (n + i) d * a (n + i)%nat)) in T'.
2: { intros k _. rewrite Sz. replace (d + (I + 3 + k))%nat with (n + k)%nat by (unfold I; lia). reflexivity. }
eapply Rle_trans; [exact T'|]. clear T T'.
set (mu := Rmax (size s c' I) (Rmax (size s c' (I + 1)) (size s c' (I + 2)))).
set (M := Rmax (a (n - 3)%nat) (Rmax (a (n - 2)%nat) (a (n - 1)%nat))).
assert (Mu : s ^ d * mu <= Binomial.C (n - 1) d * M).
{ assert (One : forall k j, (d + j = k)%nat -> (k <= n - 1)%nat -> a k <= M -> s ^ d * size s c' j <= Binomial.C (n - 1)
    d * M).
  { intros k j <- Hk Ha. rewrite Sz. apply Rmult_le_compat; auto. apply Rlt_le, binomial_pos.
    unfold a. apply Rmult_le_pos. apply Rabs_pos. apply pow_le; lra. apply binomial_increases; lia. }
  assert (M1 : a (n - 3)%nat <= M) by apply Rmax_l.
  assert (M2 : a (n - 2)%nat <= M) by (eapply Rle_trans; [apply Rmax_l|apply Rmax_r]).
  assert (M3 : a (n - 1)%nat <= M) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_r]).
  assert (A1 := One (n - 3)%nat I ltac:(unfold I; lia) ltac:(lia) M1).
  assert (A2 := One (n - 2)%nat (I + 1)%nat ltac:(unfold I; lia) ltac:(lia) M2).
  assert (A3 := One (n - 1)%nat (I + 2)%nat ltac:(unfold I; lia) ltac:(lia) M3).
  unfold mu. rewrite <- !RmaxRmult by lra. apply Rmax_lub; [|apply Rmax_lub]; auto. }
assert (Mu0 : 0 <= mu) by (eapply Rle_trans; [apply (size_pos s c' Hs I)|apply Rmax_l]).
set (q := ratio t0 s B I) in *.
assert (G : 3 * mu * q / (1 - q) <= 3 * mu).
{ apply Rmult_le_reg_r with (1 - q). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. nra. }
apply Rle_trans with (s ^ d * (3 * mu)); [apply Rmult_le_compat_l; lra|lra].
Qed.

(** ** The sums that are computed *)
Section Moved.
Variables (b t0 s B : R) (f : R -> R) (n d : nat) (p e S w : nat -> R) (u delta : R).
Hypothesis H : solution b f.
Hypothesis Hs : 0 < s.
Hypothesis HB : 1 <= B.
Hypothesis Hb : Rabs b + 2 <= B.
Hypothesis Hd : (d <= 2)%nat.
Hypothesis Hn : (5 <= n)%nat.
Hypothesis Hq : ratio t0 s B (n - 5) <= 1 / 2.
Hypothesis Hu : Rabs u <= 1.

Let a (k : nat) : R := coefficient_at f t0 k * s ^ k.
Let term (j : nat) : R := Binomial.C (d + j) d * a (d + j)%nat * u ^ j.
Let rest : R := 3 * Rmax (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat))).

Lemma left_out_of_sum : Rabs (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d) - sum_first term (n - d))
  <= Binomial.C (n - 1) d * rest * Rabs u ^ (n - 1 - d).
Proof.
assert (Sz : forall k, Rabs (a k) = Rabs (coefficient_at f t0 k) * s ^ k).
{ intros k. unfold a. rewrite Rabs_mult, (Rabs_pos_eq (s ^ k)) by (apply pow_le; lra). reflexivity. }
apply left_out. exact (derivative_at b t0 f H s u d). intros N.
assert (T := three_tails b t0 s B (coefficient_at f t0) n d N Hs HB Hb Hd Hn (coefficient_at_recurrence b t0 f H) Hq).
cbv beta zeta in T. rewrite <- !Sz in T. fold rest in T.
apply Rle_trans with
  (sum_first (fun i =>
    Rabs u ^ (n - 1 - d) * (Binomial.C (n + i) d * (Rabs (coefficient_at f t0 (n + i)) * s ^ (n + i)))) N).
- apply sum_first_le. intros k. unfold term. replace (d + (n - d + k))%nat with (n + k)%nat by lia.
  rewrite !Rabs_mult, Sz, (Rabs_pos_eq (Binomial.C (n + k) d)) by (apply Rlt_le, binomial_pos).
  rewrite Rmult_comm. apply Rmult_le_compat_r.
  + apply Rmult_le_pos; [apply Rlt_le, binomial_pos|]. apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra].
  + rewrite <- RPow_abs. replace (n - d + k)%nat with (n - 1 - d + Datatypes.S k)%nat by lia. rewrite pow_add.
    rewrite <- (Rmult_1_r (Rabs u ^ (n - 1 - d))) at 2. apply Rmult_le_compat_l; [apply pow_le, Rabs_pos|].
    rewrite <- (pow1 (Datatypes.S k)). apply pow_incr. split; [apply Rabs_pos|exact Hu].
- rewrite sum_first_factor, Rmult_comm. apply Rmult_le_compat_r; [apply pow_le, Rabs_pos|exact T].
Qed.

(** p_k approximates a_k up to e_k, the last one with the rest; w_j approximates u^j; S_k >= |p_k| + e_k *)
Hypothesis Hp : forall k, (k < n - 1)%nat -> Rabs (a k - p k) <= e k.
Hypothesis Hlast : Rabs (a (n - 1)%nat - p (n - 1)%nat) + rest <= e (n - 1)%nat.
Hypothesis HS : forall k, (k < n)%nat -> Rabs (p k) + e k <= S k.
Hypothesis Hdelta : 0 <= delta.
Hypothesis Hw : forall j, (j < n)%nat -> Rabs (w j - u ^ j) <= INR j * delta.

Lemma one_term j k E : (j <= k)%nat -> Rabs (a k - p k) + E <= e k -> 0 <= E -> Rabs (p k) + e k <= S k ->
  Rabs (w j - u ^ j) <= INR j * delta ->
  Rabs (a k * u ^ j - p k * w j) + E * Rabs u ^ j <= Rabs (w j) * e k + INR k * delta * S k.
Proof.
intros Hjk He HE HSk Hwj. assert (Hk : INR j <= INR k) by (apply le_INR, Hjk). assert (Hj := pos_INR j).
assert (A0 := Rabs_pos (a k - p k)). assert (P0 := Rabs_pos (p k)). assert (W0 := Rabs_pos (w j)).
assert (U : Rabs u ^ j <= Rabs (w j) + INR j * delta).
{ rewrite RPow_abs. replace (u ^ j) with (w j - (w j - u ^ j)) by ring. eapply Rle_trans; [apply Rabs_triang|].
  rewrite Rabs_Ropp. lra. }
assert (U0 : 0 <= Rabs u ^ j) by (apply pow_le, Rabs_pos).
assert (T : Rabs (a k * u ^ j - p k * w j) <= Rabs (a k - p k) * Rabs u ^ j + Rabs (p k) * (INR j * delta)).
{ replace (a k * u ^ j - p k * w j) with ((a k - p k) * u ^ j + p k * - (w j - u ^ j)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, Rabs_Ropp, RPow_abs. apply Rplus_le_compat_l.
  apply Rmult_le_compat_l; auto. }
assert (J : 0 <= INR j * delta) by (apply Rmult_le_pos; auto).
assert (K : INR j * delta <= INR k * delta) by (apply Rmult_le_compat_r; auto).
assert (M1 : (Rabs (a k - p k) + E) * Rabs u ^ j <= e k * (Rabs (w j) + INR j * delta)) by (apply Rmult_le_compat; lra).
assert (M2 : (Rabs (p k) + e k) * (INR j * delta) <= S k * (INR k * delta)) by (apply Rmult_le_compat; lra).
replace (Rabs (w j) * e k + INR k * delta * S k) with (e k * Rabs (w j) + S k * (INR k * delta)) by ring.
replace ((Rabs (p k) + e k) * (INR j * delta)) with (Rabs (p k) * (INR j * delta) + e k * (INR j * delta)) in M2
  by ring.
rewrite Rmult_plus_distr_l in M1. rewrite Rmult_plus_distr_r in M1. lra.
Qed.

Theorem moved_series : Rabs (s ^ d * Derive_n f d (t0 + s * u) / INR (fact d)
    - sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) (n - d))
  <= sum_first (fun j => Binomial.C (d + j) d * (Rabs (w j) * e (d + j)%nat + INR (d + j) * delta * S (d + j)%nat))
    (n - d).
Proof.
assert (L := left_out_of_sum).
assert (R0 : 0 <= rest).
{ unfold rest. assert (A := Rabs_pos (a (n - 3)%nat)).
  assert (M := Rmax_l (Rabs (a (n - 3)%nat)) (Rmax (Rabs (a (n - 2)%nat)) (Rabs (a (n - 1)%nat)))). lra. }
assert (Last : Rabs (a (n - 1)%nat * u ^ (n - 1 - d) - p (n - 1)%nat * w (n - 1 - d)%nat) + rest * Rabs u ^ (n - 1 - d)
  <= Rabs (w (n - 1 - d)%nat) * e (n - 1)%nat + INR (n - 1) * delta * S (n - 1)%nat).
{ apply one_term; auto; try lia. apply HS; lia. apply Hw; lia. }
assert (Others : forall j, (j < n - 1 - d)%nat -> Rabs (a (d + j)%nat * u ^ j - p (d + j)%nat * w j)
  <= Rabs (w j) * e (d + j)%nat + INR (d + j) * delta * S (d + j)%nat).
{ intros j Hj. assert (A := one_term j (d + j) 0 ltac:(lia)). rewrite Rmult_0_l, !Rplus_0_r in A.
  apply A; try lra. apply Hp; lia. apply HS; lia. apply Hw; lia. }
replace (n - d)%nat with (Datatypes.S (n - 1 - d)) in * by lia. set (m := (n - 1 - d)%nat) in *.
cbn [sum_first] in L |- *. replace (d + m)%nat with (n - 1)%nat by (unfold m; lia).
assert (Tm : term m = Binomial.C (n - 1) d * a (n - 1)%nat * u ^ m).
{ unfold term. replace (d + m)%nat with (n - 1)%nat by (unfold m; lia). reflexivity. }
rewrite Tm in L. set (C1 := Binomial.C (n - 1) d) in *. assert (C1p : 0 < C1) by apply binomial_pos.
set (y := s ^ d * Derive_n f d (t0 + s * u) / INR (fact d)) in *.
assert (D : Rabs (sum_first term m - sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) m)
  <= sum_first (fun j => Binomial.C (d + j) d * (Rabs (w j) * e (d + j)%nat + INR (d + j) * delta * S (d + j)%nat)) m).
{ replace (sum_first term m - sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) m)
    with (sum_first (fun j => Binomial.C (d + j) d * (a (d + j)%nat * u ^ j - p (d + j)%nat * w j)) m).
  - apply sum_bound. intros j Hj. rewrite Rabs_mult, (Rabs_pos_eq (Binomial.C _ _)) by (apply Rlt_le, binomial_pos).
    apply Rmult_le_compat_l; [apply Rlt_le, binomial_pos|apply Others, Hj].
  - apply (Rplus_eq_reg_r (sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) m)).
    rewrite <- sum_plus. unfold Rminus. rewrite Rplus_assoc, Rplus_opp_l, Rplus_0_r. apply sum_ext. intros j _.
    unfold term. ring. }
set (P := sum_first (fun j => Binomial.C (d + j) d * p (d + j)%nat * w j) m) in *.
set (ER := sum_first (fun j => Binomial.C (d + j) d * (Rabs (w j) * e (d + j)%nat + INR (d + j) * delta * S
  (d + j)%nat)) m) in *.
replace (y - (P + C1 * p (n - 1)%nat * w m))
  with ((y - (sum_first term m + C1 * a (n - 1)%nat * u ^ m))
    + ((sum_first term m - P) + C1 * (a (n - 1)%nat * u ^ m - p (n - 1)%nat * w m))) by ring.
eapply Rle_trans; [apply Rabs_triang|].
assert (T2 := Rabs_triang (sum_first term m - P) (C1 * (a (n - 1)%nat * u ^ m - p (n - 1)%nat * w m))).
rewrite Rabs_mult, (Rabs_pos_eq C1) in T2 by lra.
assert (Last' := Rmult_le_compat_l C1 _ _ (Rlt_le _ _ C1p) Last). rewrite Rmult_plus_distr_l in Last'. lra.
Qed.
End Moved.

(** ** The errors at t0 *)
Lemma solves_plus b f f1 f2 g g1 g2 : solves b f f1 f2 -> solves b g g1 g2 ->
  solves b (fun t => f t + g t) (fun t => f1 t + g1 t) (fun t => f2 t + g2 t).
Proof.
intros (D0 & D1 & D2) (G0 & G1 & G2). split; [|split]; intros t.
- apply (is_derive_plus f g); auto.
- apply (is_derive_plus f1 g1); auto.
- eapply is_derive_val. apply (is_derive_plus f2 g2); auto. unfold plus; simpl. ring.
Qed.

Lemma solves_zero b t0 f f1 f2 : solves b f f1 f2 -> f t0 = 0 -> f1 t0 = 0 -> f2 t0 = 0 -> forall t, f t = 0 /\
  f1 t = 0 /\ f2 t = 0.
Proof.
intros S H0 H1 H2. assert (Z := solves_unique b t0 f f1 f2 S H0 H1 H2). destruct S as (D0 & D1 & _).
assert (Flat : forall g g' : R -> R, (forall t, is_derive g t (g' t)) -> (forall t, g t = 0) -> forall t, g' t = 0).
{ intros g g' D E t. rewrite <- (is_derive_unique _ _ _ (D t)). rewrite (Derive_ext g (fun _ => 0)) by exact E.
  apply Derive_const. }
assert (Z1 := Flat f f1 D0 Z). assert (Z2 := Flat f1 f2 D1 Z1). auto.
Qed.

Theorem solution_with_values b t0 y0 y1 y2 : exists f, solution b f /\ f t0 = y0 /\ Derive f t0 = y1 /\
  Derive_n f 2 t0 = y2 /\
  forall g, solution b g -> g t0 = y0 -> Derive g t0 = y1 -> Derive_n g 2 t0 = y2 -> forall t, g t = f t.
Proof.
set (c := from_values b t0 y0 y1 (y2 / 2)).
assert (S := series_solves b t0 c (from_values_recurrence _ _ _ _ _)).
set (f := fun t => PSeries c (t - t0)) in *. set (f1 := fun t => PSeries (PS_derive c) (t - t0)) in *.
set (f2 := fun t => PSeries (PS_derive (PS_derive c)) (t - t0)) in *.
assert (Z : t0 - t0 = 0) by ring.
assert (V0 : f t0 = y0) by (unfold f; rewrite Z, PSeries_0; reflexivity).
assert (V1 : f1 t0 = y1) by (unfold f1; rewrite Z, PSeries_0; unfold PS_derive, c, from_values; simpl; ring).
assert (V2 : f2 t0 = y2).
{ unfold f2. rewrite Z, PSeries_0. unfold PS_derive. change (c 2%nat) with (y2 / 2). simpl. field. }
assert (E1 : forall t, Derive f t = f1 t) by (intros t; exact (is_derive_unique f t (f1 t) (proj1 S t))).
assert (E2 : forall t, Derive_n f 2 t = f2 t).
{ intros t. simpl. rewrite (Derive_ext _ f1) by exact E1. exact (is_derive_unique f1 t (f2 t) (proj1 (proj2 S) t)). }
exists f. split; [exact (solves_solution b f f1 f2 S)|]. split; [auto|]. rewrite E1, E2. split; [auto|]. split; [auto|].
intros g Hg G0 G1 G2 t.
assert (U := solves_plus b _ _ _ _ _ _ (solution_solves b g Hg) (solves_scal b f f1 f2 (-1) S)).
assert (A := solves_unique b t0 _ _ _ U). cbv beta in A.
specialize (A ltac:(rewrite G0, V0; ring) ltac:(rewrite G1, V1; ring) ltac:(rewrite G2, V2; ring) t). lra.
Qed.

Theorem carried_errors b t0 s (F G : R -> R) (E : nat -> R -> R) (e : nat -> R) (d : nat) t : 0 < s -> (d <= 2)%nat ->
  solution b F -> solution b G -> (forall j, (j < 3)%nat -> solution b (E j)) ->
  let a f k := Derive_n f k t0 / INR (fact k) * s ^ k in
  (forall i j, (i < 3)%nat -> (j < 3)%nat -> a (E j) i = if Nat.eqb i j then 1 else 0) ->
  (forall j, (j < 3)%nat -> Rabs (a F j - a G j) <= e j) ->
  Rabs (Derive_n F d t - Derive_n G d t) <= sum_first (fun j => e j * Rabs (Derive_n (E j) d t)) 3.
Proof.
intros Hs Hd HF HG HE a Unit He.
set (x := fun j => a F j - a G j).
assert (S : forall j w, (j < 3)%nat -> solves b (fun t => w * E j t) (fun t => w * Derive (E j) t) (fun t =>
  w * Derive_n (E j) 2 t)).
{ intros j w Hj. exact (solves_scal b _ _ _ w (solution_solves b (E j) (HE j Hj))). }
assert (D := solves_plus b _ _ _ _ _ _ (solution_solves b F HF)
  (solves_plus b _ _ _ _ _ _ (solves_scal b _ _ _ (-1) (solution_solves b G HG))
  (solves_plus b _ _ _ _ _ _ (S 0%nat (- x 0%nat) ltac:(lia))
    (solves_plus b _ _ _ _ _ _ (S 1%nat (- x 1%nat) ltac:(lia)) (S 2%nat (- x 2%nat) ltac:(lia)))))).
assert (Z := solves_zero b t0 _ _ _ D). cbv beta in Z.
assert (At : forall f k, (k < 3)%nat -> Derive_n f k t0 = a f k * INR (fact k) / s ^ k).
{ intros f k _. unfold a. field. split. apply INR_fact_neq_0. apply pow_nonzero; lra. }
assert (Sum : forall k, (k < 3)%nat -> Derive_n F k t0 + (-1 * Derive_n G k t0 + (- x 0%nat * Derive_n (E 0%nat) k t0
  + (- x 1%nat * Derive_n (E 1%nat) k t0 + - x 2%nat * Derive_n (E 2%nat) k t0))) = 0).
{ intros k Hk. rewrite !(At _ k Hk), !(Unit k) by lia. unfold x. assert (P := pow_nonzero s k ltac:(lra)).
  assert (Q := INR_fact_neq_0 k).
  destruct k as [|[|[|k]]]; [| | |lia]; cbn [Nat.eqb]; field; repeat split; auto; lra. }
specialize (Z (Sum 0%nat ltac:(lia)) (Sum 1%nat ltac:(lia)) (Sum 2%nat ltac:(lia)) t).
assert (L : Derive_n F d t - Derive_n G d t = sum_first (fun j => x j * Derive_n (E j) d t) 3).
{ cbn [sum_first]. destruct Z as (Z0 & Z1 & Z2). destruct d as [|[|[|d]]]; [| | |lia].
  - change (F t - G t = 0 + x 0%nat * E 0%nat t + x 1%nat * E 1%nat t + x 2%nat * E 2%nat t). lra.
  - change (Derive F t - Derive G t = 0 + x 0%nat * Derive (E 0%nat) t + x 1%nat * Derive (E 1%nat) t + x 2%nat * Derive
      (E 2%nat) t). lra.
  - lra. }
rewrite L. apply sum_bound. intros j Hj. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. exact (He j Hj).
Qed.
