(** * The derivative in b

    The sum of an entire family c_k(b) t^k has the derivative sum c_k'(b) t^k in b, the sum of an entire family again
    ([beta_derived_entire]): a power series of norm M on the radius r has a derivative of norm at most M/r on r/2, and
    differs from its first two terms by at most M (|h|/r)^2. Such sums are continuous in (t, b) ([family_joint]). Theta
    is one of them, and so are its derivatives. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus WellPosed Family ContinuityInBeta EntireForm PowerSeriesNorm NormLimit
  GammaEntire ThetaEntire.
Open Scope R_scope.

(** ** Continuity in two variables *)

Definition joint (f : R -> R -> R) (t b : R) : Prop := continuous (fun z : R * R => f (fst z) (snd z)) (t, b).

Lemma joint_ext_loc (f g : R -> R -> R) (t b : R) : locally b (fun b : R => forall t : R, f t b = g t b) ->
  joint f t b -> joint g t b.
Proof.
intros [d Hd] F. apply (continuous_ext_loc _ (fun z : R * R => f (fst z) (snd z))); [|exact F].
exists d. intros [u v] [_ Hv]. apply Hd, Hv.
Qed.

Lemma joint_along f (z : R -> R) b : continuous z b -> joint f (z b) b -> continuous (fun b => f (z b) b) b.
Proof. intros Hz F. exact (continuous_comp_2 z (fun b => b) f b Hz (continuous_id b) F). Qed.

(** Lipschitz in t with a constant that depends continuously on b. *)
Lemma joint_of_lipschitz (f : R -> R -> R) (K : R -> R) (t b : R) : continuous (f t) b -> continuous K b ->
  locally b (fun c : R => forall u : R, Rabs (u - t) <= 1 -> Rabs (f u c - f t c) <= Rabs (u - t) * K c) -> joint f t b.
Proof.
intros Cf CK HL. apply filterlim_locally. intros eps. assert (He := cond_pos eps).
assert (He2 : 0 < eps / 2) by lra.
apply filterlim_locally with (eps := mkposreal _ He2) in Cf.
apply filterlim_locally with (eps := mkposreal 1 Rlt_0_1) in CK.
destruct (filter_and _ _ HL (filter_and _ _ Cf CK)) as [d Hd].
set (M := Rabs (K b) + 1). assert (HM : 0 < M) by (unfold M; generalize (Rabs_pos (K b)); lra).
assert (Hm : 0 < Rmin 1 (Rmin d (eps / (2 * M)))).
{ repeat apply Rmin_pos; try lra. apply cond_pos. apply Rdiv_lt_0_compat; lra. }
exists (mkposreal _ Hm). intros [u c] [Hu Hc]; simpl in *.
change (Rabs (u - t) < Rmin 1 (Rmin d (eps / (2 * M)))) in Hu.
change (Rabs (c - b) < Rmin 1 (Rmin d (eps / (2 * M)))) in Hc.
change (Rabs (f u c - f t b) < eps).
assert (A1 := Rmin_l 1 (Rmin d (eps / (2 * M)))). assert (A2 := Rmin_r 1 (Rmin d (eps / (2 * M)))).
assert (A3 := Rmin_l d (eps / (2 * M))). assert (A4 := Rmin_r d (eps / (2 * M))).
destruct (Hd c) as (H1 & H2 & H3). { change (Rabs (c - b) < d). lra. }
change (Rabs (f t c - f t b) < eps / 2) in H2. change (Rabs (K c - K b) < 1) in H3.
specialize (H1 u ltac:(lra)).
replace (f u c - f t b) with ((f u c - f t c) + (f t c - f t b)) by ring.
eapply Rle_lt_trans; [apply Rabs_triang|].
assert (HK : Rabs (u - t) * K c <= Rabs (u - t) * M).
{ apply Rmult_le_compat_l. apply Rabs_pos. unfold M. assert (B := Rle_abs (K b)). apply Rabs_def2 in H3. lra. }
assert (HE : Rabs (u - t) * M <= eps / (2 * M) * M) by (apply Rmult_le_compat_r; lra).
replace (eps / (2 * M) * M) with (eps / 2) in HE by (field; lra). lra.
Qed.

(** ** The derivative of a power series *)

Lemma sum_first_shift u N : sum_first (fun n => u (S n)) N = sum_first u (S N) - u 0%nat.
Proof. induction N as [|N IH]; simpl in *. ring. rewrite IH. ring. Qed.

Lemma successor_power n : INR (S n) <= 2 ^ n.
Proof. induction n as [|n IH]. simpl; lra. rewrite S_INR. simpl pow. assert (1 <= 2 ^ n) by (apply pow_R1_Rle; lra).
lra. Qed.

Lemma norm_derive r M f : 0 < r -> norm_at_most r M f -> norm_at_most (r / 2) (M / r) (Derive f).
Proof.
intros Hr (a & Ha & Hf). exists (PS_derive a). split.
- intros N. apply Rle_trans with (/ r * sum_first (fun n => Rabs (a (S n)) * r ^ S n) N).
  + rewrite <- sum_first_scal. apply sum_first_le. intros n. unfold PS_derive.
    rewrite Rabs_mult, Rabs_pos_eq by apply pos_INR. rewrite pow_quotient.
    assert (P := successor_power n). assert (P2 : 0 < 2 ^ n) by (apply pow_lt; lra).
    assert (Pr : 0 < r ^ n) by (apply pow_lt, Hr).
    replace (/ r * (Rabs (a (S n)) * r ^ S n)) with (2 ^ n * (Rabs (a (S n)) * (r ^ n / 2 ^ n))) by (simpl; field; lra).
    rewrite Rmult_assoc. apply Rmult_le_compat_r; auto.
    apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rdiv_lt_0_compat; auto.
  + rewrite (sum_first_shift (fun n => Rabs (a n) * r ^ n)). unfold Rdiv. rewrite Rmult_comm.
    apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, Hr.
    assert (P := Rabs_pos (a 0%nat)). specialize (Ha (S N)). simpl pow at 2. lra.
- intros x Hx. assert (HR := radius_at_least a r M Hr Ha x ltac:(lra)).
  rewrite (Derive_ext_loc f (PSeries a)); [apply is_pseries_derive, HR|].
  assert (Hp : 0 < r - Rabs x) by (generalize (Rabs_pos x); lra). exists (mkposreal _ Hp). intros y Hy.
  change (Rabs (y - x) < r - Rabs x) in Hy.
  symmetry. apply is_pseries_unique, Hf. assert (T := Rabs_triang_inv y x). lra.
Qed.

Lemma norm_second_order r M f h : 0 < r -> norm_at_most r M f -> Rabs h < r ->
  Rabs (f h - f 0 - h * Derive f 0) <= M * (Rabs h / r) ^ 2.
Proof.
intros Hr Hf Hh. destruct (taylor_coefficients r M f Hr Hf) as [HM HS].
assert (T := series_tail _ r M Hr HM h (f h) 2 ltac:(lra) (HS h Hh)).
replace (f h - f 0 - h * Derive f 0) with (f h - sum_first (fun n => taylor f n * h ^ n) 2); auto.
cbn [sum_first]. unfold taylor. change (Derive_n f 0 0) with (f 0). change (Derive_n f 1 0) with (Derive f 0).
simpl INR. simpl pow. field.
Qed.

Lemma Derive_translate f x h : Derive (fun h => f (x + h)) h = Derive f (x + h).
Proof. unfold Derive. f_equal. apply Lim_ext. intros e. rewrite Rplus_assoc. reflexivity. Qed.

(** ** Families *)

Definition beta_derived (c : nat -> R -> R) (k : nat) (b : R) : R := Derive (c k) b.

Lemma beta_derived_entire c : entire_family c -> entire_family (beta_derived c).
Proof.
intros H b r R Hr HR. destruct (H b (2 * r) R ltac:(lra) HR) as [M HM]. exists (M / (2 * r)). intros k.
assert (P : 0 < R ^ k) by (apply pow_lt, HR).
replace (M / (2 * r) / R ^ k) with (M / R ^ k / (2 * r)) by (field; lra). replace r with (2 * r / 2) at 1 by field.
apply (norm_ext _ _ (Derive (fun h => c k (b + h)))); [intros h _; apply Derive_translate|]. apply norm_derive; auto.
lra.
Qed.

Theorem family_beta_derive c t b : entire_family c -> is_derive (fun b => family_sum c t b) b
  (family_sum (beta_derived c) t b).
Proof.
intros H. set (R := 2 * (Rabs t + 1)). assert (At := Rabs_pos t).
destruct (H b 2 R ltac:(lra) ltac:(unfold R; lra)) as [M HM].
apply (derive_of_quadratic _ b _ (M * 2)). intros h Hh.
assert (L := is_lim_seq_minus' _ _ _ _ (is_lim_seq_minus' _ _ _ _
  (proj1 (is_pseries_sum_first _ _ _) (family_correct c t (b + h) H)) (proj1 (is_pseries_sum_first _ _ _)
    (family_correct c t b H)))
  (is_lim_seq_mult' _ _ _ _ (is_lim_seq_const h) (proj1 (is_pseries_sum_first _ _ _)
    (family_correct _ t b (beta_derived_entire c H))))).
apply is_lim_seq_abs in L.
refine (is_lim_seq_le _ (fun _ => h ^ 2 * (M * 2)) _ _ _ L (is_lim_seq_const _)). intros N. cbv beta.
set (d := fun k => (c k (b + h) - c k b - h * beta_derived c k b) * t ^ k).
replace (_ - _) with (sum_first d N).
2: { rewrite (sum_first_ext d (fun k =>
       c k (b + h) * t ^ k + (-1 * (c k b * t ^ k) + - h * (beta_derived c k b * t ^ k)))).
     - rewrite !sum_first_plus, !sum_first_scal. ring.
     - intros k. unfold d. ring. }
eapply Rle_trans; [apply sum_first_abs|].
apply Rle_trans with (sum_first (fun k => h ^ 2 * (M * (1 / 2) ^ k)) N).
- apply sum_first_le. intros k. unfold d. rewrite Rabs_mult, <- RPow_abs.
  assert (T := norm_second_order 2 _ _ h ltac:(lra) (HM k) ltac:(lra)). cbv beta in T.
  rewrite Rplus_0_r, Derive_translate, Rplus_0_r in T. fold (beta_derived c k b) in T.
  assert (PR : 0 < R ^ k) by (apply pow_lt; unfold R; lra). assert (P2 : 0 < 2 ^ k) by (apply pow_lt; lra).
  assert (M0 := norm_bound_nonneg _ _ _ (HM k)).
  assert (Q : (Rabs h / 2) ^ 2 <= h ^ 2). { rewrite <- (pow2_abs h). assert (A := Rabs_pos h). simpl. nra. }
  apply Rle_trans with (M / R ^ k * h ^ 2 * (R ^ k * (1 / 2) ^ k)); [|right; field; lra].
  apply Rmult_le_compat; try apply Rabs_pos. apply pow_le, At.
  + eapply Rle_trans; [exact T|]. apply Rmult_le_compat_l; auto.
  + rewrite <- Rpow_mult_distr. apply pow_incr. unfold R. lra.
- rewrite sum_first_scal, sum_first_scal. apply Rmult_le_compat_l. apply pow2_ge_0. apply Rmult_le_compat_l.
  + assert (V := norm_bound_nonneg _ _ _ (HM 0%nat)). simpl in V. lra.
  + assert (G := sum_geometric (1 / 2) N ltac:(lra)). replace (/ (1 - 1 / 2)) with 2 in G by field. exact G.
Qed.

Theorem family_joint c t b : entire_family c -> joint (family_sum c) t b.
Proof.
intros H. assert (A := Rabs_pos t).
destruct (family_substitute (derived c) b 1 (Rabs t + 1) (derived_entire c H) Rlt_0_1 ltac:(lra)) as [M HM].
apply (joint_of_lipschitz _ (fun _ => M)).
- apply (ex_derive_continuous (family_sum c t)). eexists. apply family_beta_derive, H.
- apply continuous_const.
- exists (mkposreal 1 Rlt_0_1). intros e He u Hu. change (Rabs (e - b) < 1) in He.
  destruct (MVT_gen (fun t => family_sum c t e) t u (fun t => family_sum (derived c) t e)) as (xi & Hxi & E).
  + intros s _. apply family_derive, H.
  + intros s _. apply derivable_continuous_pt. eexists. apply is_derive_Reals, family_derive, H.
  + rewrite E, Rabs_mult, Rmult_comm. apply Rmult_le_compat_l. apply Rabs_pos.
    assert (V := norm_value 1 M (fun h => family_sum (derived c) xi (b + h)) (e - b) Rlt_0_1). cbv beta in V.
    assert (Ee : b + (e - b) = e) by (apply Rplus_minus).
    rewrite Ee in V. apply V; auto.
    apply (HM 1 (fun _ => xi)). lra. apply (norm_weaken 1 (Rabs xi)); [|apply norm_const].
    assert (T := Rabs_triang t (xi - t)). replace (t + (xi - t)) with xi in T by ring.
    assert (Rabs (xi - t) <= 1); [|lra]. apply Rabs_le_between in Hu. apply Rabs_le.
    revert Hxi. unfold Rmin, Rmax. destruct Rle_dec; lra.
Qed.

(** ** Theta off the integers *)

Lemma locally_above (b lo : R) : lo < b -> locally b (fun c => lo < c).
Proof.
intros H. assert (Hp : 0 < b - lo) by lra. exists (mkposreal _ Hp). intros y Hy.
change (Rabs (y - b) < b - lo) in Hy. apply Rabs_def2 in Hy. lra.
Qed.

Lemma locally_below (b hi : R) : b < hi -> locally b (fun c => c < hi).
Proof.
intros H. assert (Hp : 0 < hi - b) by lra. exists (mkposreal _ Hp). intros y Hy.
change (Rabs (y - b) < hi - b) in Hy. apply Rabs_def2 in Hy. lra.
Qed.


Definition Th_slope (t b : R) : R := Derive (fun b => Th b t) b.

Lemma Th_derive_in_b b t : not_nat b -> is_derive (fun b => Th b t) b (family_sum (beta_derived theta_coefficient) t b).
Proof.
intros Hb. apply (is_derive_ext_loc (fun b => family_sum theta_coefficient t b));
  [|apply family_beta_derive, theta_family_entire].
eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy. symmetry. apply Th_family, Hy.
Qed.

Theorem Th_ex_derive b : not_nat b -> forall t, ex_derive (fun b => Th b t) b.
Proof. intros Hb t. eexists. apply Th_derive_in_b, Hb. Qed.

Theorem Th_slope_joint b : not_nat b -> forall t, joint Th_slope t b.
Proof.
intros Hb t. apply (joint_ext_loc (family_sum (beta_derived theta_coefficient))).
- eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy u. symmetry. apply is_derive_unique, Th_derive_in_b, Hy.
- apply family_joint, beta_derived_entire, theta_family_entire.
Qed.
