(** * Theta is differentiable in b

    For b < 0, Gamma(-b) Theta(t, b) = int r^(-b-1) e^(rt - r^3/3) dr and Gamma(-b) itself are differentiable in the exponent ([ExponentDerivative.v]),
    with derivatives that are continuous in (t, b); the recurrence Theta(t, b) = -t Theta(t, b - 1) + (b - 1)(b - 2) Theta(t, b - 3)
    carries this to every b that is not an integer >= 0. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral GammaFunction LaplaceIntegral WellPosed ImproperIntegral Family
  ContinuityInBeta CompliantKernel ExponentDerivative.
Open Scope R_scope.

(** ** Continuity in two variables *)

Definition joint (f : R -> R -> R) (t b : R) : Prop := continuous (fun z : R * R => f (fst z) (snd z)) (t, b).

Lemma joint_plus f g t b : joint f t b -> joint g t b -> joint (fun t b => f t b + g t b) t b.
Proof. intros F G. exact (continuous_plus (fun z : R * R => f (fst z) (snd z)) (fun z => g (fst z) (snd z)) (t, b) F G). Qed.

Lemma joint_mult f g t b : joint f t b -> joint g t b -> joint (fun t b => f t b * g t b) t b.
Proof. intros F G. exact (continuous_mult (fun z : R * R => f (fst z) (snd z)) (fun z => g (fst z) (snd z)) (t, b) F G). Qed.

Lemma joint_fst (f : R -> R) t b : continuous f t -> joint (fun t _ => f t) t b.
Proof. intros F. apply (continuous_comp (@fst R R) f). apply continuous_fst. exact F. Qed.

Lemma joint_snd (f : R -> R) t b : continuous f b -> joint (fun _ b => f b) t b.
Proof. intros F. apply (continuous_comp (@snd R R) f). apply continuous_snd. exact F. Qed.

Lemma joint_ext_loc (f g : R -> R -> R) (t b : R) : locally b (fun b : R => forall t : R, f t b = g t b) -> joint f t b -> joint g t b.
Proof.
intros [d Hd] F. apply (continuous_ext_loc _ (fun z : R * R => f (fst z) (snd z))); [|exact F].
exists d. intros [u v] [_ Hv]. apply Hd, Hv.
Qed.

Lemma joint_comp f (h : R -> R) t b : continuous h b -> joint f t (h b) -> joint (fun t b => f t (h b)) t b.
Proof.
intros Hh F.
apply (continuous_comp_2 (fun z : R * R => fst z) (fun z : R * R => h (snd z)) f).
- apply continuous_fst.
- apply (continuous_comp (@snd R R) h). apply continuous_snd. exact Hh.
- exact F.
Qed.

Lemma joint_along f (z : R -> R) b : continuous z b -> joint f (z b) b -> continuous (fun b => f (z b) b) b.
Proof. intros Hz F. exact (continuous_comp_2 z (fun b => b) f b Hz (continuous_id b) F). Qed.

(** Lipschitz in t with a constant that depends continuously on b. *)
Lemma joint_of_lipschitz (f : R -> R -> R) (K : R -> R) (t b : R) : continuous (f t) b -> continuous K b ->
  locally b (fun c : R => forall u : R, Rabs (u - t) <= 1 -> Rabs (f u c - f t c) <= Rabs (u - t) * K c) -> joint f t b.
Proof.
intros Cf CK HL. apply filterlim_locally. intros eps. assert (He := cond_pos eps).
assert (He2 : 0 < eps / 2) by lra.
apply filterlim_locally with (eps := mkposreal _ He2) in Cf. apply filterlim_locally with (eps := mkposreal 1 Rlt_0_1) in CK.
destruct (filter_and _ _ HL (filter_and _ _ Cf CK)) as [d Hd].
set (M := Rabs (K b) + 1). assert (HM : 0 < M) by (unfold M; generalize (Rabs_pos (K b)); lra).
assert (Hm : 0 < Rmin 1 (Rmin d (eps / (2 * M)))).
{ repeat apply Rmin_pos; try lra. apply cond_pos. apply Rdiv_lt_0_compat; lra. }
exists (mkposreal _ Hm). intros [u c] [Hu Hc]; simpl in *.
change (Rabs (u - t) < Rmin 1 (Rmin d (eps / (2 * M)))) in Hu. change (Rabs (c - b) < Rmin 1 (Rmin d (eps / (2 * M)))) in Hc.
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

(** ** The two families, b < 0 *)

Definition weight (t r : R) : R := exp (r * t - r ^ 3 / 3).
Definition theta_moment (t c : R) : R := Gamma (c + 1) * Th (- c - 1) t.
Definition gamma_moment (c : R) : R := Gamma (c + 1).

Lemma weight_pos t r : 0 < r -> 0 <= weight t r.
Proof. intros _. apply Rlt_le, exp_pos. Qed.

Lemma weight_continuous t r : 0 < r -> continuous (weight t) r.
Proof. intros _. apply (ex_derive_continuous (weight t)). unfold weight. auto_derive; auto. Qed.

Lemma theta_moment_integral t c : -1 < c ->
  is_RInt_gen (fun r => Rpower r c * weight t r) (at_right 0) (Rbar_locally p_infty) (theta_moment t c).
Proof.
intros Hc. assert (Hn : not_nat (- c - 1)) by (apply not_nat_neg; lra).
assert (H := Theta_representation (- c - 1) (Th (- c - 1)) 0 Hn ltac:(simpl; lra) (Th_correct _) t).
simpl Derive_n in H. simpl INR in H.
replace (0 - (- c - 1) - 1) with c in H by ring. unfold theta_moment.
replace (c + 1) with (- (- c - 1)) by ring. exact H.
Qed.

Lemma gamma_moment_integral c : -1 < c ->
  is_RInt_gen (fun r => Rpower r c * exp (- r)) (at_right 0) (Rbar_locally p_infty) (gamma_moment c).
Proof.
intros Hc. assert (H := Gamma_correct (c + 1) ltac:(lra)). replace (c + 1 - 1) with c in H by ring. exact H.
Qed.

Definition theta_log (t c : R) : R := log_integral (weight t) c.
Definition gamma_log (c : R) : R := log_integral (fun r => exp (- r)) c.

Lemma theta_moment_derive t c : -1 < c -> is_derive (theta_moment t) c (theta_log t c).
Proof. exact (exponent_derive (weight t) (theta_moment t) (weight_pos t) (weight_continuous t) (theta_moment_integral t) c). Qed.

Lemma exp_minus_pos r : 0 < r -> 0 <= exp (- r).
Proof. intros _. apply Rlt_le, exp_pos. Qed.

Lemma exp_minus_continuous r : 0 < r -> continuous (fun r => exp (- r)) r.
Proof. intros _. apply (ex_derive_continuous (fun r => exp (- r))). auto_derive; auto. Qed.

Lemma gamma_moment_derive c : -1 < c -> is_derive gamma_moment c (gamma_log c).
Proof. exact (exponent_derive _ gamma_moment exp_minus_pos exp_minus_continuous gamma_moment_integral c). Qed.

Lemma gamma_log_continuous c : -1 < c -> continuous gamma_log c.
Proof. exact (log_integral_continuous _ gamma_moment exp_minus_pos exp_minus_continuous gamma_moment_integral c). Qed.

Lemma theta_log_continuous t c : -1 < c -> continuous (theta_log t) c.
Proof. exact (log_integral_continuous _ (theta_moment t) (weight_pos t) (weight_continuous t) (theta_moment_integral t) c). Qed.

(** |weight u - weight t| <= |u - t| r weight (t + 1), |u - t| <= 1 *)
Lemma weight_change t u r : 0 < r -> Rabs (u - t) <= 1 -> Rabs (weight u r - weight t r) <= Rabs (u - t) * (r * weight (t + 1) r).
Proof.
intros Hr Hu. unfold weight.
replace (r * u - r ^ 3 / 3) with (r * t - r ^ 3 / 3 + r * (u - t)) by ring.
replace (r * (t + 1) - r ^ 3 / 3) with (r * t - r ^ 3 / 3 + r) by ring. rewrite !exp_plus.
set (E := exp (r * t - r ^ 3 / 3)). assert (HE : 0 < E) by apply exp_pos.
replace (E * exp (r * (u - t)) - E) with (E * (exp (r * (u - t)) - 1)) by ring. rewrite Rabs_mult, (Rabs_pos_eq E) by lra.
replace (Rabs (u - t) * (r * (E * exp r))) with (E * (r * Rabs (u - t) * exp r)) by ring.
apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [apply exp_minus_1|].
rewrite Rabs_mult, (Rabs_pos_eq r) by lra. assert (P := Rabs_pos (u - t)).
apply Rmult_le_compat_l. apply Rmult_le_pos; lra.
apply exp_le. rewrite <- (Rmult_1_r r) at 2. apply Rmult_le_compat_l; lra.
Qed.

Lemma theta_moment_lipschitz t u c : -1 < c -> Rabs (u - t) <= 1 ->
  Rabs (theta_moment u c - theta_moment t c) <= Rabs (u - t) * theta_moment (t + 1) (c + 1).
Proof.
intros Hc Hu.
assert (P1 := theta_moment_integral u c Hc). assert (P2 := theta_moment_integral t c Hc).
assert (D := is_RInt_gen_minus _ _ _ _ P1 P2).
assert (B := theta_moment_integral (t + 1) (c + 1) ltac:(lra)). apply (is_RInt_gen_scal _ (Rabs (u - t))) in B.
refine (improper_abs _ _ _ _ _ D B).
intros r Hr. unfold minus, plus, opp, scal; simpl; unfold mult; simpl.
replace (Rpower r c * weight u r + - (Rpower r c * weight t r)) with (Rpower r c * (weight u r - weight t r)) by ring.
assert (P : 0 < Rpower r c) by apply exp_pos. rewrite Rabs_mult, (Rabs_pos_eq _ (Rlt_le _ _ P)).
rewrite Rpower_S by auto.
replace (Rabs (u - t) * (r * Rpower r c * weight (t + 1) r)) with (Rpower r c * (Rabs (u - t) * (r * weight (t + 1) r))) by ring.
apply Rmult_le_compat_l; [lra|]. apply weight_change; auto.
Qed.

Lemma theta_log_lipschitz t u c : -1 < c -> Rabs (u - t) <= 1 ->
  Rabs (theta_log u c - theta_log t c) <= Rabs (u - t) * (theta_moment (t + 1) (c + 2) + theta_moment (t + 1) c).
Proof.
intros Hc Hu.
assert (L : forall v, is_RInt_gen (fun r => Rpower r c * ln r * weight v r) (at_right 0) (Rbar_locally p_infty) (theta_log v c)).
{ intros v. exact (ex_log_integral (weight v) (theta_moment v) (weight_pos v) (weight_continuous v) (theta_moment_integral v) c Hc). }
assert (Lu := L u). assert (Lt := L t). assert (D := is_RInt_gen_minus _ _ _ _ Lu Lt).
assert (P1 := theta_moment_integral (t + 1) (c + 2) ltac:(lra)). assert (P2 := theta_moment_integral (t + 1) c Hc).
assert (B := is_RInt_gen_plus _ _ _ _ P1 P2).
apply (is_RInt_gen_scal _ (Rabs (u - t))) in B.
refine (improper_abs _ _ _ _ _ D B).
intros r Hr. unfold minus, plus, opp, scal; simpl; unfold mult; simpl.
replace (Rpower r c * ln r * weight u r + - (Rpower r c * ln r * weight t r)) with (Rpower r c * (ln r * (weight u r - weight t r))) by ring.
set (P := Rpower r c). assert (HP : 0 < P) by apply exp_pos. rewrite !Rabs_mult, (Rabs_pos_eq P) by lra.
rewrite Rpower_SS by auto. fold P.
assert (W := weight_change t u r Hr Hu). assert (HW : 0 <= weight (t + 1) r) by (apply weight_pos, Hr).
set (w := weight (t + 1) r) in *. set (q := Rabs (u - t)) in *. assert (Hq : 0 <= q) by apply Rabs_pos.
replace (q * (r ^ 2 * P * w + P * w)) with (P * (q * (r ^ 2 + 1) * w)) by ring.
apply Rmult_le_compat_l; [lra|].
assert (Y : Rabs (ln r) * r <= r ^ 2 + 1).
{ assert (A := abs_le_exp 1 (ln r) Rlt_0_1). assert (A' := exp_abs 1 (ln r) ltac:(lra)).
  replace (exp (1 * ln r)) with r in A' by (rewrite Rmult_1_l, exp_ln; auto).
  replace (exp (- (1) * ln r)) with (/ r) in A' by (replace (- (1) * ln r) with (- ln r) by ring; rewrite exp_Ropp, exp_ln; auto).
  assert (A2 : Rabs (ln r) <= r + / r) by lra.
  apply (Rmult_le_compat_r r) in A2; [|lra]. replace ((r + / r) * r) with (r ^ 2 + 1) in A2 by (field; lra). exact A2. }
apply Rle_trans with (Rabs (ln r) * (q * (r * w))).
- apply Rmult_le_compat_l; auto. apply Rabs_pos.
- replace (Rabs (ln r) * (q * (r * w))) with (q * w * (Rabs (ln r) * r)) by ring.
  replace (q * (r ^ 2 + 1) * w) with (q * w * (r ^ 2 + 1)) by ring. apply Rmult_le_compat_l; auto. apply Rmult_le_pos; auto.
Qed.

Lemma theta_moment_continuous t c : -1 < c -> continuous (theta_moment t) c.
Proof. intros Hc. apply (ex_derive_continuous (theta_moment t)). eexists. apply theta_moment_derive, Hc. Qed.

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

Lemma shift_continuous (f : R -> R) c a : continuous f (c + a) -> continuous (fun c => f (c + a)) c.
Proof.
intros H. apply (continuous_comp (fun c => c + a) f); [|exact H].
apply (ex_derive_continuous (fun c => c + a)). auto_derive; auto.
Qed.

Lemma theta_moment_joint t c : -1 < c -> joint theta_moment t c.
Proof.
intros Hc. apply (joint_of_lipschitz theta_moment (fun c => theta_moment (t + 1) (c + 1))); auto.
- apply theta_moment_continuous, Hc.
- apply (shift_continuous (theta_moment (t + 1))), theta_moment_continuous. lra.
- eapply filter_imp; [|apply (locally_above c (-1) Hc)]. intros d Hd u Hu. apply theta_moment_lipschitz; auto.
Qed.

Lemma theta_log_joint t c : -1 < c -> joint theta_log t c.
Proof.
intros Hc. apply (joint_of_lipschitz theta_log (fun c => theta_moment (t + 1) (c + 2) + theta_moment (t + 1) c)); auto.
- apply theta_log_continuous, Hc.
- apply (continuous_plus (fun c => theta_moment (t + 1) (c + 2)) (theta_moment (t + 1))).
  apply (shift_continuous (theta_moment (t + 1))), theta_moment_continuous. lra.
  apply theta_moment_continuous. lra.
- eapply filter_imp; [|apply (locally_above c (-1) Hc)]. intros d Hd u Hu. apply theta_log_lipschitz; auto.
Qed.

(** ** Theta, b < 0 *)

Definition slope_negative (t b : R) : R := (- theta_log t (- b - 1) + gamma_log (- b - 1) * Th b t) / Gamma (- b).

Lemma Th_moment b t : b < 0 -> Th b t = theta_moment t (- b - 1) / gamma_moment (- b - 1).
Proof.
intros Hb. unfold theta_moment, gamma_moment. replace (- b - 1 + 1) with (- b) by ring. replace (- (- b - 1) - 1) with b by ring.
field. apply Rgt_not_eq, Gamma_pos. lra.
Qed.

Lemma reflect_derive (f : R -> R) b l : is_derive f (- b - 1) l -> is_derive (fun b => f (- b - 1)) b (- l).
Proof.
intros H. apply (is_derive_val _ _ (-1 * l)); [|ring].
apply (is_derive_comp f (fun b => - b - 1) b l (-1)). exact H. auto_derive; auto; ring.
Qed.

Lemma Th_derive_negative b t : b < 0 -> is_derive (fun b => Th b t) b (slope_negative t b).
Proof.
intros Hb. assert (Hg := Gamma_pos (- b) ltac:(lra)).
assert (Eg : gamma_moment (- b - 1) = Gamma (- b)) by (unfold gamma_moment; f_equal; ring).
apply (is_derive_ext_loc (fun b => theta_moment t (- b - 1) / gamma_moment (- b - 1))).
{ eapply filter_imp; [|apply (locally_below b 0 Hb)]. intros y Hy. symmetry. apply Th_moment, Hy. }
assert (D1 := reflect_derive (theta_moment t) b _ (theta_moment_derive t (- b - 1) ltac:(lra))).
assert (D2 := reflect_derive gamma_moment b _ (gamma_moment_derive (- b - 1) ltac:(lra))).
apply (is_derive_val _ _ ((- theta_log t (- b - 1) * gamma_moment (- b - 1) - theta_moment t (- b - 1) * - gamma_log (- b - 1)) / gamma_moment (- b - 1) ^ 2)).
- apply (is_derive_div (fun b => theta_moment t (- b - 1)) (fun b => gamma_moment (- b - 1))); auto. rewrite Eg. lra.
- unfold slope_negative. rewrite (Th_moment b t Hb), Eg. field. lra.
Qed.

Lemma reflect_joint f t b : joint f t (- b - 1) -> joint (fun t b => f t (- b - 1)) t b.
Proof.
intros H. apply (joint_comp f (fun b => - b - 1)); auto.
apply (ex_derive_continuous (fun b => - b - 1)). auto_derive; auto.
Qed.

Lemma gamma_inverse_continuous b : b < 0 -> continuous (fun b => / gamma_moment (- b - 1)) b.
Proof.
intros Hb. apply (ex_derive_continuous (fun b => / gamma_moment (- b - 1))).
eexists. apply (is_derive_inv (fun b => gamma_moment (- b - 1))).
- apply reflect_derive, gamma_moment_derive. lra.
- unfold gamma_moment. apply Rgt_not_eq, Gamma_pos. lra.
Qed.

Lemma Th_joint_negative b t : b < 0 -> joint (fun t b => Th b t) t b.
Proof.
intros Hb. apply (joint_ext_loc (fun t b => theta_moment t (- b - 1) * / gamma_moment (- b - 1))).
{ eapply filter_imp; [|apply (locally_below b 0 Hb)]. intros y Hy u. symmetry. apply Th_moment, Hy. }
apply joint_mult.
- apply reflect_joint, theta_moment_joint. lra.
- apply (joint_snd (fun b => / gamma_moment (- b - 1))), gamma_inverse_continuous, Hb.
Qed.

Lemma slope_joint_negative b t : b < 0 -> joint slope_negative t b.
Proof.
intros Hb.
apply (joint_ext_loc (fun t b => (-1 * theta_log t (- b - 1) + gamma_log (- b - 1) * Th b t) * / gamma_moment (- b - 1))).
{ eapply filter_imp; [|apply (locally_below b 0 Hb)]. intros y Hy u. unfold slope_negative, gamma_moment, Rdiv.
  replace (- y - 1 + 1) with (- y) by ring. ring. }
apply joint_mult; [|apply (joint_snd (fun b => / gamma_moment (- b - 1))), gamma_inverse_continuous, Hb].
apply joint_plus.
- apply joint_mult. apply (joint_snd (fun _ => -1)), continuous_const. apply reflect_joint, theta_log_joint. lra.
- apply joint_mult; [|apply Th_joint_negative, Hb].
  apply (joint_snd (fun b => gamma_log (- b - 1))). apply (continuous_comp (fun b => - b - 1) gamma_log).
  apply (ex_derive_continuous (fun b => - b - 1)). auto_derive; auto. apply gamma_log_continuous. lra.
Qed.

(** ** Every b that is not an integer >= 0 *)

Lemma not_nat_induction (P : R -> Prop) : (forall b, b < 0 -> P b) ->
  (forall b, not_nat b -> P (b - 1) -> P (b - 3) -> P b) -> forall b, not_nat b -> P b.
Proof.
intros H0 HS b Hb.
assert (H : forall n b, b < INR n -> not_nat b -> P b).
{ induction n as [|n IH]; intros c Hc Hn.
  - apply H0. simpl in Hc. lra.
  - rewrite S_INR in Hc. apply HS; auto; apply IH; try lra.
    + apply not_nat_pred, Hn.
    + intros k Hk. apply (Hn (k + 3)%nat). rewrite plus_INR. simpl. lra. }
destruct (nfloor_ex (Rabs b) (Rabs_pos b)) as [n [_ Hn]]. apply (H (S n)); auto. rewrite S_INR. assert (A := Rle_abs b). lra.
Qed.

Lemma not_nat_open b : not_nat b -> locally b not_nat.
Proof.
intros Hb. destruct (near_not_nat b) as [d Hd]. exists d. intros y Hy. destruct (Req_dec y b) as [->|Hn]; auto.
Qed.

Definition Th_slope (t b : R) : R := Derive (fun b => Th b t) b.

Lemma slope_step b t : ex_derive (fun b => Th b t) (b - 1) -> ex_derive (fun b => Th b t) (b - 3) -> not_nat b ->
  is_derive (fun b => Th b t) b (- t * Th_slope t (b - 1) + (2 * b - 3) * Th (b - 3) t + (b - 1) * (b - 2) * Th_slope t (b - 3)).
Proof.
intros E1 E3 Hb.
apply (is_derive_ext_loc (fun b => - t * Th (b - 1) t + (b - 1) * (b - 2) * Th (b - 3) t)).
{ eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy. symmetry. apply Th_rec, Hy. }
assert (S : forall a, ex_derive (fun b => Th b t) (b - a) -> is_derive (fun b => Th (b - a) t) b (Th_slope t (b - a))).
{ intros a E. apply Derive_correct in E. apply (is_derive_val _ _ (1 * Th_slope t (b - a))); [|ring].
  apply (is_derive_comp (fun b => Th b t) (fun b => b - a) b (Th_slope t (b - a)) 1). exact E. auto_derive; auto; ring. }
apply (is_derive_val _ _ (- t * Th_slope t (b - 1) + ((2 * b - 3) * Th (b - 3) t + (b - 1) * (b - 2) * Th_slope t (b - 3)))); [|ring].
apply (is_derive_plus (fun b => - t * Th (b - 1) t) (fun b => (b - 1) * (b - 2) * Th (b - 3) t)).
- apply (is_derive_scal (fun b => Th (b - 1) t)). apply S, E1.
- apply (is_derive_mult_R (fun b => (b - 1) * (b - 2)) (fun b => Th (b - 3) t)).
  auto_derive; auto; ring. apply S, E3.
Qed.

Theorem Th_ex_derive b : not_nat b -> forall t, ex_derive (fun b => Th b t) b.
Proof.
apply (not_nat_induction (fun b => forall t, ex_derive (fun b => Th b t) b)).
- intros c Hc t. eexists. apply Th_derive_negative, Hc.
- intros c Hc H1 H3 t. eexists. apply slope_step; auto.
Qed.

Lemma Th_slope_negative b t : b < 0 -> Th_slope t b = slope_negative t b.
Proof. intros Hb. apply is_derive_unique, Th_derive_negative, Hb. Qed.

Lemma not_nat_sub3 b : not_nat b -> not_nat (b - 3).
Proof. intros H k Hk. apply (H (k + 3)%nat). rewrite plus_INR. simpl. lra. Qed.

Lemma Th_slope_rec b t : not_nat b ->
  Th_slope t b = - t * Th_slope t (b - 1) + (2 * b - 3) * Th (b - 3) t + (b - 1) * (b - 2) * Th_slope t (b - 3).
Proof.
intros Hb. apply is_derive_unique. apply slope_step; auto; apply Th_ex_derive. apply not_nat_pred, Hb. apply not_nat_sub3, Hb.
Qed.

Lemma joint_shift f t b a : joint f t (b - a) -> joint (fun t b => f t (b - a)) t b.
Proof.
intros H. apply (joint_comp f (fun b => b - a)); auto. apply (ex_derive_continuous (fun b => b - a)). auto_derive; auto.
Qed.

Lemma joint_poly (f : R -> R) t b : ex_derive f b -> joint (fun _ b => f b) t b.
Proof. intros H. apply joint_snd, (ex_derive_continuous f), H. Qed.

Theorem Th_joint b : not_nat b -> forall t, joint (fun t b => Th b t) t b.
Proof.
apply (not_nat_induction (fun b => forall t, joint (fun t b => Th b t) t b)).
- intros c Hc t. apply Th_joint_negative, Hc.
- intros c Hc H1 H3 t.
  apply (joint_ext_loc (fun t b => - t * Th (b - 1) t + (b - 1) * (b - 2) * Th (b - 3) t)).
  { eapply filter_imp; [|apply (not_nat_open c Hc)]. intros y Hy u. symmetry. apply Th_rec, Hy. }
  apply joint_plus; apply joint_mult.
  + apply (joint_fst (fun t => - t)). apply (ex_derive_continuous (fun t => - t)). auto_derive; auto.
  + apply (joint_shift (fun t b => Th b t)), H1.
  + apply (joint_poly (fun b => (b - 1) * (b - 2))). auto_derive; auto.
  + apply (joint_shift (fun t b => Th b t)), H3.
Qed.

Theorem Th_slope_joint b : not_nat b -> forall t, joint Th_slope t b.
Proof.
apply (not_nat_induction (fun b => forall t, joint Th_slope t b)).
- intros c Hc t. apply (joint_ext_loc slope_negative).
  + eapply filter_imp; [|apply (locally_below c 0 Hc)]. intros y Hy u. symmetry. apply Th_slope_negative, Hy.
  + apply slope_joint_negative, Hc.
- intros c Hc H1 H3 t.
  destruct (Rlt_le_dec c 0) as [Hneg|Hpos].
  { apply (joint_ext_loc slope_negative); [|apply slope_joint_negative, Hneg].
    eapply filter_imp; [|apply (locally_below c 0 Hneg)]. intros y Hy u. symmetry. apply Th_slope_negative, Hy. }
  apply (joint_ext_loc (fun t b => - t * Th_slope t (b - 1) + (2 * b - 3) * Th (b - 3) t + (b - 1) * (b - 2) * Th_slope t (b - 3))).
  { eapply filter_imp; [|apply (not_nat_open c Hc)]. intros y Hy u. symmetry. apply Th_slope_rec, Hy. }
  apply joint_plus; [apply joint_plus|]; apply joint_mult.
  + apply (joint_fst (fun t => - t)). apply (ex_derive_continuous (fun t => - t)). auto_derive; auto.
  + apply (joint_shift Th_slope), H1.
  + apply (joint_poly (fun b => 2 * b - 3)). auto_derive; auto.
  + apply (joint_shift (fun t b => Th b t)). apply Th_joint, not_nat_sub3, Hc.
  + apply (joint_poly (fun b => (b - 1) * (b - 2))). auto_derive; auto.
  + apply (joint_shift Th_slope), H3.
Qed.
